/// The one place that includes stb_image, with the formats that are read.
#pragma once

#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#include <stb_image.h>
