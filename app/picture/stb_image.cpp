// Somebody else's source, compiled here and warned about there.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#define STB_IMAGE_IMPLEMENTATION
#include "app/picture/stb_image.h"
#pragma GCC diagnostic pop
