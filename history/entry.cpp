#include "history/entry.h"
