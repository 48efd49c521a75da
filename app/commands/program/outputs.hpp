#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/kinematics/proof/proof_record.hpp"
#include "lessons/lesson/lesson.hpp"

namespace jw {

/// Checks an output before anything is computed: it must be writable, and must not be one of the files that
/// are read, under any name, link or not. Fonts count, too, since everything that draws reads them.
/// @param option  names the output
/// @throws CommandError (bad_input) or std::runtime_error
void check_output(
    const std::string& option, const std::filesystem::path& output,
    const std::vector<std::filesystem::path>& inputs);

/// True if `path` is the regular file that standard output or standard error is redirected into.
bool is_own_output(const std::filesystem::path& path);

/// Writes a proof for docs/proofs/check_proof.py: JSON in one line. The last key `sha256` is the hash of the
/// text before it, so that a damaged file can be told from a wrong proof.
void write_proof(
    const std::filesystem::path& file, const ProofRecord& proof, const System& system, const Lesson& lesson);

}  // namespace jw
