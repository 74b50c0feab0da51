// The worker's side: serves requests until the client goes away.
#pragma once

namespace etalon {

// Runs the loop of a worker process and returns its exit status. `main` calls this where the first
// argument is "worker"; never returns while the client lives.
int ServeWorker(int argc, char** argv);

}  // namespace etalon
