#pragma once

#include <filesystem>

#include "core/kinematics/proof/proof_record.hpp"
#include "lessons/lesson/lesson.hpp"

namespace jw {

/// Writes a proof for docs/proofs/check_proof.py: JSON in one line. The last key `sha256` is the hash of the
/// text before it, so that a damaged file can be told from a wrong proof.
void write_proof(
    const std::filesystem::path& file, const ProofRecord& proof, const System& system, const Lesson& lesson);

}  // namespace jw
