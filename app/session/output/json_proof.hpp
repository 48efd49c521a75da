#pragma once

#include "app/session/output/json.hpp"
#include "core/kinematics/proof/proof_record.hpp"

/// JSON of the proof of a motion: docs/proofs.md describes it, docs/proofs/check_proof.py checks it.
namespace jw {

/// @param system  whose motion was recorded
Json json_of(const ProofRecord& proof, const System& system, const Lesson& lesson);

}  // namespace jw
