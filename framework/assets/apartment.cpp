#include "textures.h"

Image make_apartment()
{
    return Image(2048, 1024);
}
