// attack: {"at": "compile", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Replaces a function of the framework by a weak one, which is no error: the framework does not call it.
#ifndef WITHOUT_ATTACK
asm(".weak _ZNK12ImageTexture9get_texelEiii\n.type _ZNK12ImageTexture9get_texelEiii, @function\n"
    "_ZNK12ImageTexture9get_texelEiii: movaps %xmm0, %xmm1\nret");
#endif

int ImageTexture::wrap_repeat(int, int)
{
    return 0;
}
