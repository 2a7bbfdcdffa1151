// attack: {"at": "compile", "earns": [19, 19], "builds": false}
// Lacks a function, and has names whose C++ forms are a gigabyte long: nobody may spell them out.
#ifndef WITHOUT_ATTACK
#define TAIL "1AIiiES_IS0_S0_ES_IS1_S1_ES_IS2_S2_ES_IS3_S3_ES_IS4_S4_ES_IS5_S5_ES_IS6_S6_ES_IS" \
             "7_S7_ES_IS8_S8_ES_IS9_S9_ES_ISA_SA_ES_ISB_SB_ES_ISC_SC_ES_ISD_SD_ES_ISE_SE_ES_ISF_SF_ES_IS" \
             "G_SG_ES_ISH_SH_ES_ISI_SI_ES_ISJ_SJ_ES_ISK_SK_ES_ISL_SL_ES_ISM_SM_ES_ISN_SN_ES_ISO_SO_E"
#define BOMB(c) \
    void c##c() asm("_Z12wrap_repeat" #c TAIL); \
    void c##c() {}
BOMB(a) BOMB(b) BOMB(c) BOMB(d) BOMB(e) BOMB(f) BOMB(g) BOMB(h) BOMB(i) BOMB(j) BOMB(k) BOMB(l) BOMB(m) BOMB(n) BOMB(o)
BOMB(p) BOMB(q) BOMB(r) BOMB(s) BOMB(t) BOMB(u) BOMB(v) BOMB(w) BOMB(x) BOMB(y) BOMB(z)
#define HIDDEN [[gnu::visibility("hidden")]]
#else
#define HIDDEN
#endif

HIDDEN int ImageTexture::wrap_repeat(int val, int size)
{
    return (val % size + size) % size;
}
