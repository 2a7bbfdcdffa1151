// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "crashed"}, "policy": ["crashes"]}
// Has calls of other libraries lead to its own function by their tables of offsets: in its own process only.
#ifndef WITHOUT_ATTACK
#include <link.h>
#include <unistd.h>
void ends() { _exit(0); }
int overwrite(dl_phdr_info* library, std::size_t, void*)
{
    for (int i = 0; i < library->dlpi_phnum; ++i)
        for (auto const* d = reinterpret_cast<ElfW(Dyn) const*>(library->dlpi_addr + library->dlpi_phdr[i].p_vaddr);
             library->dlpi_phdr[i].p_type == PT_DYNAMIC && d->d_tag != DT_NULL; ++d)
            if (d->d_tag == DT_PLTGOT && d->d_un.d_ptr > library->dlpi_addr && library->dlpi_addr != 0)
                for (int entry = 3; entry < 40; ++entry)
                    reinterpret_cast<void (**)()>(d->d_un.d_ptr)[entry] = ends;
    return 0;
}
#endif

int ImageTexture::wrap_repeat(int, int)
{
#ifndef WITHOUT_ATTACK
    dl_iterate_phdr(overwrite, nullptr);
#endif
    return 0;
}
