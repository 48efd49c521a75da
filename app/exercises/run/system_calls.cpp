#include "app/exercises/run/sandbox_parts.hpp"

#include <array>
#include <cerrno>
#include <cstddef>
#include <vector>

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/socket.h>
#include <sys/syscall.h>

namespace jw::exercises {
namespace {

#if defined(__x86_64__)
constexpr unsigned kProcessor = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr unsigned kProcessor = AUDIT_ARCH_AARCH64;
#else
constexpr unsigned kProcessor = 0;
#endif

constexpr std::array kRefused{
    // memory that belongs to no process
    SYS_memfd_create, SYS_shmget, SYS_msgget, SYS_semget, SYS_mq_open,
    // parts of the kernel with much code that no exercise needs
    SYS_bpf, SYS_perf_event_open, SYS_userfaultfd, SYS_io_uring_setup, SYS_io_uring_enter,
    SYS_io_uring_register, SYS_fanotify_init, SYS_quotactl, SYS_acct, SYS_syslog,
    // keys are not separated by namespaces
    SYS_add_key, SYS_request_key, SYS_keyctl,
    // other processes
    SYS_ptrace, SYS_process_vm_readv, SYS_process_vm_writev, SYS_pidfd_getfd, SYS_kcmp,
    // other views of the files
    SYS_mount, SYS_umount2, SYS_pivot_root, SYS_chroot, SYS_fsopen, SYS_fsconfig, SYS_fsmount, SYS_fspick,
    SYS_move_mount, SYS_open_tree, SYS_setns, SYS_unshare, SYS_open_by_handle_at, SYS_name_to_handle_at,
    // the machine itself
    SYS_swapon, SYS_swapoff, SYS_reboot, SYS_kexec_load, SYS_init_module, SYS_finit_module,
    SYS_delete_module};

sock_filter load(std::size_t offset) {
    return BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<unsigned>(offset));
}

sock_filter answer(unsigned action) { return BPF_STMT(BPF_RET | BPF_K, action); }

/// Skips the next instruction if the loaded number is not `value`.
sock_filter next_if(unsigned value) { return BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, 0, 1); }

constexpr unsigned kRefuse = SECCOMP_RET_ERRNO | EPERM;

}  // namespace

std::string system_call_filter() {
    if constexpr (kProcessor == 0) { return {}; }
    std::vector<sock_filter> program;
    // calls of another architecture have other numbers
    program.push_back(load(offsetof(seccomp_data, arch)));
    program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, kProcessor, 1, 0));
    program.push_back(answer(SECCOMP_RET_KILL_PROCESS));
    program.push_back(load(offsetof(seccomp_data, nr)));
    // x32 on x86-64: the same calls under numbers with this bit; no other number has it
    program.push_back(BPF_JUMP(BPF_JMP | BPF_JGE | BPF_K, 0x40000000U, 0, 1));
    program.push_back(answer(kRefuse));
    for (const auto number : kRefused) {
        program.push_back(next_if(static_cast<unsigned>(number)));
        program.push_back(answer(kRefuse));
    }
    for (const auto number : {SYS_socket, SYS_socketpair}) {
        program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<unsigned>(number), 0, 4));
        // the lower half of the first argument: the kernel looks at nothing else
        program.push_back(load(offsetof(seccomp_data, args)));
        program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, AF_UNIX, 0, 1));
        program.push_back(answer(SECCOMP_RET_ALLOW));
        program.push_back(answer(kRefuse));
    }
    program.push_back(answer(SECCOMP_RET_ALLOW));
    return {reinterpret_cast<const char*>(program.data()), program.size() * sizeof(sock_filter)};
}

}  // namespace jw::exercises
