#include "app/commands/proof_file.hpp"

#include "app/host/frames/frame_draft.hpp"
#include "app/session/output/json_proof.hpp"
#include "render/files/atomic_file.hpp"

namespace jw {

void write_proof(
    const std::filesystem::path& file, const ProofRecord& proof, const System& system, const Lesson& lesson) {
    std::string text = json_document(json_of(proof, system, lesson), -1);
    text.resize(text.rfind('}'));
    const std::string hash = host::sha256_of(render::bytes_of(text));
    render::write_file_atomically(file, text + ",\"sha256\":\"" + hash + "\"}\n");
}

}  // namespace jw
