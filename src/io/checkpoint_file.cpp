#include "io/checkpoint_file.hpp"

#include <bit>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>

#include "bioprint/errors.hpp"
#include "bioprint/io/answer.hpp"
#include "io/byte_source.hpp"
#include "io/whole_file.hpp"

static_assert(std::endian::native == std::endian::little, "checkpoints hold little-endian numbers");

namespace bioprint {
namespace {

using PlainJson = nlohmann::json;
using Bytes = std::vector<std::uint8_t>;

constexpr std::string_view checkpoint_format = "bioprint-checkpoint/1";

std::string_view view(const Bytes& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

Bytes bytes_of(const std::vector<double>& numbers) {
    Bytes bytes(numbers.size() * sizeof(double));
    if (!bytes.empty()) std::memcpy(bytes.data(), numbers.data(), bytes.size());
    return bytes;
}

std::vector<double> numbers_of(const Bytes& bytes) {
    std::vector<double> numbers(bytes.size() / sizeof(double));
    if (!numbers.empty()) std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(double));
    return numbers;
}

std::string whole(const std::string& path) {
    const auto source = open_bytes(path);
    constexpr std::size_t piece = std::size_t{1} << 20U;
    std::string text;
    for (std::size_t size = 0;;) {
        text.resize(size + piece);
        const std::size_t count = source->read(text.data() + size, piece);
        size += count;
        if (count == 0) {
            text.resize(size);
            return text;
        }
    }
}

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
    throw DataError(path + ": " + why + "; remove it and --resume begins that run anew");
}

}  // namespace

unsigned long long checksum(std::string_view bytes, unsigned long long seed) {
    constexpr unsigned long long prime = 0x100000001b3ULL;
    for (const char c : bytes) seed = (seed ^ static_cast<unsigned char>(c)) * prime;
    return seed;
}

void write_checkpoint(const std::string& path, const CheckpointParts& parts, const CheckpointParts& more) {
    PlainJson content = PlainJson::object();
    for (const CheckpointParts* part : {&parts, &more}) {
        for (const auto& [name, numbers] : *part) content[name] = PlainJson::binary(bytes_of(numbers));
    }
    Bytes inner = PlainJson::to_cbor(content);
    content = nullptr;
    const unsigned long long sum = checksum(view(inner));
    const Bytes outer = PlainJson::to_cbor(PlainJson{{"format", checkpoint_format},
                                                     {"program", program_version()},
                                                     {"checksum", sum},
                                                     {"content", PlainJson::binary(std::move(inner))}});
    WholeFile file(path);
    file.write(view(outer));
    file.commit();
}

CheckpointParts read_checkpoint(const std::string& path) {
    const std::string text = whole(path);
    try {
        const PlainJson outer = PlainJson::from_cbor(text, true, false);
        if (!outer.is_object()) refuse(path, "the checkpoint is cut short or damaged");
        if (outer.at("format") != checkpoint_format) refuse(path, "is not a checkpoint of this kind");
        if (outer.at("program") != program_version()) {
            refuse(path, "the checkpoint is of version " + outer.at("program").get<std::string>() +
                             ", whose numbers this one need not continue");
        }
        const Bytes& inner = outer.at("content").get_binary();
        if (outer.at("checksum") != checksum(view(inner))) refuse(path, "the checkpoint is damaged");
        CheckpointParts parts;
        const PlainJson content = PlainJson::from_cbor(inner);
        for (const auto& [name, numbers] : content.items()) parts[name] = numbers_of(numbers.get_binary());
        return parts;
    } catch (const PlainJson::exception&) {
        refuse(path, "the checkpoint is damaged");
    }
}

}  // namespace bioprint
