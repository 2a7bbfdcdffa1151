// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// Lacks a function, and has a name whose C++ form is a gigabyte long: nobody may spell that out.
#ifndef WITHOUT_ATTACK
void grows() asm("_Z1f1AIiiES_IS0_S0_ES_IS1_S1_ES_IS2_S2_ES_IS3_S3_ES_IS4_S4_ES_IS5_S5_ES_IS6_S6_ES_IS7_S7_E"
                 "S_IS8_S8_ES_IS9_S9_ES_ISA_SA_ES_ISB_SB_ES_ISC_SC_ES_ISD_SD_ES_ISE_SE_ES_ISF_SF_ES_ISG_SG_E"
                 "S_ISH_SH_ES_ISI_SI_ES_ISJ_SJ_ES_ISK_SK_ES_ISL_SL_ES_ISM_SM_ES_ISN_SN_ES_ISO_SO_E");
void grows() {}
#define HIDDEN [[gnu::visibility("hidden")]]
#else
#define HIDDEN
#endif

HIDDEN int ImageTexture::wrap_repeat(int val, int size)
{
    return (val % size + size) % size;
}
