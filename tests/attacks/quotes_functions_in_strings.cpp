// attack: {"at": "compile", "earns": [20, 20]}
// What is no function to a compiler, but may look like one: definitions in strings, in comments, in what is left out.
#ifndef WITHOUT_ATTACK
char const* const raw = R"end(
int ImageTexture::wrap_clamp(int val, int size) { return )" + 0; } /* " ' )en" {{{
)end";
int const separated = 1'000'000 + '"' + u8R"(")"[0];
// the next line belongs to this one \
int ImageTexture::wrap_clamp(int val, int size) { return 1; }
/\
* and so does this to a comment: int ImageTexture::wrap_clamp(int val, int size) { return 2; } *\
/
#if 0
int ImageTexture::wrap_clamp(int val, int size) {
#endif
%:define OPEN <%
#endif
