// Block memory: where the blocks come from that the program asks for with new. Each thread keeps what it drops in lists
// by size.
#pragma once

namespace kinegraph::app {

/// What this thread keeps goes back to the process. To be called last by a thread that ends.
void give_back_block_memory();

}  // namespace kinegraph::app
