// Number memory: where the limbs of exact numbers come from. A construction makes and drops some ten thousand short
// numbers; each thread keeps what it drops in lists by size and takes it from there again.
#pragma once

namespace kinegraph {

/// From now on GMP and MPFR (all of the process that uses the same copy of them) take their memory so. To be called
/// once, by the program, before it has a second thread; numbers made before may live on. A library calls it not: the
/// memory of its user's numbers is its user's. Does nothing under AddressSanitizer, which must see every number end.
void keep_number_memory();

/// What this thread keeps goes back to the process.
void give_back_number_memory();

}  // namespace kinegraph
