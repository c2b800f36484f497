#include "io/vtk.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "bioprint/io/number_format.hpp"

namespace bioprint {
namespace {

constexpr int triangle = 5;  // VTK's numbers of cell types
constexpr int tetrahedron = 10;

void append_base64(std::string& text, const std::vector<unsigned char>& bytes) {
    static constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t left = bytes.size() - i;
        const unsigned word = (static_cast<unsigned>(bytes[i]) << 16U) |
                              (left > 1 ? static_cast<unsigned>(bytes[i + 1]) << 8U : 0U) |
                              (left > 2 ? static_cast<unsigned>(bytes[i + 2]) : 0U);
        text += letters[word >> 18U];
        text += letters[(word >> 12U) & 63U];
        text += left > 1 ? letters[(word >> 6U) & 63U] : '=';
        text += left > 2 ? letters[word & 63U] : '=';
    }
}

template <class Number>
constexpr const char* type_name() {
    if constexpr (std::is_same_v<Number, double>) return "Float64";
    if constexpr (std::is_same_v<Number, float>) return "Float32";
    if constexpr (std::is_same_v<Number, std::int32_t>) return "Int32";
    return "UInt8";
}

/// One array of a file: its length in bytes, then its numbers.
template <class Number>
class DataArray {
  public:
    DataArray(const char* name, int components) : name_(name), components_(components) {
        bytes_.resize(sizeof(std::uint64_t));
    }
    template <class Value>
    void add(Value value) {
        auto number = static_cast<Number>(value);
        if constexpr (std::is_floating_point_v<Number>) {
            if (!std::isfinite(number)) number = 0;
        }
        const std::size_t at = bytes_.size();
        bytes_.resize(at + sizeof(Number));
        std::memcpy(bytes_.data() + at, &number, sizeof(Number));
    }
    template <class Value>
    void add(const std::array<Value, 3>& values) {
        for (const Value value : values) add(value);
    }
    template <class List>
    DataArray& of(const List& list) {
        bytes_.reserve(bytes_.size() + list.size() * static_cast<std::size_t>(components_) * sizeof(Number));
        for (const auto& value : list) add(value);
        return *this;
    }
    void write(std::string& text) {
        const std::uint64_t size = bytes_.size() - sizeof(std::uint64_t);
        std::memcpy(bytes_.data(), &size, sizeof(size));
        text += std::string("        <DataArray type=\"") + type_name<Number>() + "\" Name=\"" + name_ +
                (components_ > 1 ? "\" NumberOfComponents=\"" + std::to_string(components_) : "") +
                "\" format=\"binary\">\n";
        append_base64(text, bytes_);
        text += "\n        </DataArray>\n";
    }

  private:
    const char* name_;
    int components_;
    std::vector<unsigned char> bytes_;
};

template <class Number, class List>
void write_array(std::string& text, const char* name, int components, const List& list) {
    DataArray<Number>(name, components).of(list).write(text);
}

std::string opening(const char* kind) {
    return std::string("<?xml version=\"1.0\"?>\n<VTKFile type=\"") + kind +
           "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n";
}

std::string triple(const std::array<double, 3>& values) {
    return format_shortest(values[0]) + " " + format_shortest(values[1]) + " " + format_shortest(values[2]);
}

}  // namespace

std::string vtu_text(const CellPicture& cell) {
    const auto per_element = static_cast<std::size_t>(cell.nodes_per_element);
    const std::size_t count = cell.elements.size() / per_element;
    std::vector<std::int32_t> ends;
    for (std::size_t e = 1; e <= count; ++e) ends.push_back(static_cast<std::int32_t>(e * per_element));
    const std::vector<int> kinds(count, per_element == 3 ? triangle : tetrahedron);
    std::string text = opening("UnstructuredGrid");
    text += "  <UnstructuredGrid>\n    <Piece NumberOfPoints=\"" + std::to_string(cell.position.size()) +
            "\" NumberOfCells=\"" + std::to_string(count) + "\">\n";
    text += "      <Points>\n";
    write_array<double>(text, "position", 3, cell.position);
    text += "      </Points>\n      <Cells>\n";
    write_array<std::int32_t>(text, "connectivity", 1, cell.elements);
    write_array<std::int32_t>(text, "offsets", 1, ends);
    write_array<std::uint8_t>(text, "types", 1, kinds);
    text += "      </Cells>\n      <PointData Vectors=\"displacement\">\n";
    write_array<double>(text, "displacement", 3, cell.displacement);
    text += "      </PointData>\n      <CellData Scalars=\"von_mises\">\n";
    write_array<double>(text, "von_mises", 1, cell.von_mises);
    write_array<double>(text, "jacobian", 1, cell.jacobian);
    return text + "      </CellData>\n    </Piece>\n  </UnstructuredGrid>\n</VTKFile>\n";
}

std::string vti_text(const FlowPicture& flow) {
    std::string extent;
    for (const int nodes : flow.nodes) {
        extent += (extent.empty() ? "0 " : " 0 ") + std::to_string(nodes - 1);
    }
    std::string text = opening("ImageData");
    text += "  <ImageData WholeExtent=\"" + extent + "\" Origin=\"" + triple(flow.origin) + "\" Spacing=\"" +
            triple({flow.spacing, flow.spacing, flow.spacing}) + "\">\n    <Piece Extent=\"" + extent +
            "\">\n";
    text += "      <PointData Scalars=\"stress\" Vectors=\"velocity\">\n";
    write_array<float>(text, "velocity", 3, flow.velocity);
    write_array<float>(text, "pressure", 1, flow.pressure);
    write_array<float>(text, "shear_rate", 1, flow.shear_rate);
    write_array<float>(text, "viscosity", 1, flow.viscosity);
    write_array<float>(text, "stress", 1, flow.stress);
    if (!flow.fluid.empty()) write_array<std::uint8_t>(text, "fluid", 1, flow.fluid);
    return text + "      </PointData>\n    </Piece>\n  </ImageData>\n</VTKFile>\n";
}

std::string pvd_text(const std::vector<TimelineEntry>& entries) {
    std::string text = opening("Collection") + "  <Collection>\n";
    for (const TimelineEntry& entry : entries) {
        text +=
            "    <DataSet timestep=\"" + format_shortest(entry.time) + "\" file=\"" + entry.file + "\"/>\n";
    }
    return text + "  </Collection>\n</VTKFile>\n";
}

}  // namespace bioprint
