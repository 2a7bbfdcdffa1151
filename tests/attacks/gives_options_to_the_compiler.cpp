// attack: {"at": "compile", "earns": [20, 20]}
// Names options that write files or load plugins where only levels of optimisation may stand: left out.
#ifndef WITHOUT_ATTACK
#pragma GCC optimize("dump-tree-all=/tmp/attacked", "plugin=@UPLOAD@/secret.h", "save-temps")
[[gnu::optimize("dump-tree-all=attacked", "wrapper=/bin/sh")]] int one()
{
    return 1;
}
#endif
