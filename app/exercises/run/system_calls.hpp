#pragma once

#include <string>

namespace jw::exercises {

/// A filter of system calls for bwrap, as the bytes of a BPF program; empty on processors that it is not
/// written for.
///
/// A program of a student needs files, memory and processes. Refused is what reaches more of the kernel than
/// that (bpf, io_uring, keys, mounts, other processes), what takes memory that no limit counts (memfd, System
/// V shared memory), and every socket but those between its own processes: not all kinds of sockets belong to
/// a network namespace (AF_VSOCK reaches the host of a virtual machine).
std::string system_call_filter();

}  // namespace jw::exercises
