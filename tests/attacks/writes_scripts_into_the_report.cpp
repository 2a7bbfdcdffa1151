// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// Scripts for the browser of whoever opens the report as a page, in a message of the compiler, in what it quotes, and in
// the text of the file: they are shown as text. tests/browser tries the same in all other places.
#ifndef WITHOUT_ATTACK
#error </pre></script><script>owned(1)</script><img src=x onerror=owned(2)> {{{script}}} [[a|b]]
struct Owned {
    char const* text = "</code></pre><script>owned(3)</script><!--";
    </span><script>owned(4)</script>
};
#endif
