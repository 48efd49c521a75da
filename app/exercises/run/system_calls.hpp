#pragma once

#include <string>

namespace jw::exercises {

/// A filter of system calls for bwrap, as the bytes of a BPF program; empty on processors for which it is not
/// written.
///
/// A student's program needs files, memory and processes. The filter refuses calls that reach more of the
/// kernel (bpf, io_uring, keys, mounts, other processes), calls that take memory that no limit counts (memfd,
/// System V shared memory), and every socket except those between the program's own processes: some kinds of
/// sockets do not belong to a network namespace (AF_VSOCK reaches the host of a virtual machine).
std::string system_call_filter();

}  // namespace jw::exercises
