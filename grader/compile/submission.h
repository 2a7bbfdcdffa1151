// Precompiled for uploads: what every file that defines the eleven functions includes. A file that includes less is
// compiled without it, so nothing may be added here that such files can do without.
#include <cglib/rt/object.h>
#include <cglib/rt/texture.h>
#include <cglib/rt/transform.h>
