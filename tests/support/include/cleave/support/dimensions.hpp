#pragma once

/// The dimensions that templates are instantiated for in the tests: calls M(D) for each.
#define CLEAVE_FOR_EACH_DIMENSION(M) M(1) M(2) M(3) M(4)
