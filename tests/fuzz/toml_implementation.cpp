// The bodies of toml++, once: Debian's library holds them without instrumentation.
#define TOML_IMPLEMENTATION
#include <toml++/toml.h>
