#include "io/gnuplot_script.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "bioprint/io/number_format.hpp"
#include "io/text.hpp"

namespace bioprint {
namespace {

// L* of 0, 33, 49, 61, 71 and 82; tests/cli/pictures.py measures them, and their distances for colour-blind eyes.
constexpr std::array<LineStyle, 6> styles = {{{"#000000", "solid", 7},
                                              {"#004f8c", "(14,6)", 5},
                                              {"#c44e00", "(5,4)", 9},
                                              {"#00a878", "(14,4,3,4)", 13},
                                              {"#e69f00", "(2,4)", 11},
                                              {"#9ad3f5", "solid", 6}}};
constexpr std::string_view grey = "#8a8a8a";
constexpr int title_height = 34;
constexpr std::size_t narrow_key = 14;  ///< bytes of a key entry that leave room for a second column

/// A gnuplot string that means `text` and nothing else: in single quotes nothing but the quote itself is
/// special. Control characters and bytes that are no UTF-8 would break an SVG and are left out.
std::string quoted(std::string_view text) {
    std::string out = "'";
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        const auto byte = static_cast<unsigned char>(text.front());
        if (length == 0 || (length == 1 && (byte < 0x20 || byte == 0x7F))) {
            out += length == 0 ? "\xEF\xBF\xBD" : " ";
        } else {
            out += text.substr(0, length);
            if (byte == '\'') out += '\'';
        }
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return out + "'";
}

std::string num(double value) {
    return format_shortest(value);
}

struct Extent {
    double low = 0.0;
    double high = 0.0;
    bool empty = true;
    void add(double value) {
        if (!std::isfinite(value)) return;
        low = empty ? value : std::min(low, value);
        high = empty ? value : std::max(high, value);
        empty = false;
    }
    [[nodiscard]] double magnitude() const { return std::max(std::abs(low), std::abs(high)); }
};

Extent extent_of(const Panel& panel, bool of_x) {
    Extent extent;
    for (const Series& series : panel.series) {
        for (const double value : of_x ? series.x : series.y) extent.add(value);
    }
    const Axis& axis = of_x ? panel.x : panel.y;
    if (axis.min) extent.add(*axis.min);
    if (axis.max) extent.add(*axis.max);
    return extent;
}

/// How numbers of an axis are written: divided by a lab unit that stands in the title.
struct Scale {
    double unit = 1.0;
    std::string title;
    double operator()(double value) const { return value / unit; }
};

Scale scale_of(const Axis& axis, const Extent& extent) {
    if (!axis.dimension || *axis.dimension == Dimension::dimensionless) return {1.0, axis.title};
    // Over decades the middle one is read, not the highest.
    const bool decades = axis.logarithmic && extent.low > 0.0;
    const double read = decades ? std::sqrt(extent.low * extent.high) : extent.magnitude();
    const LabUnit& unit = choose_lab_unit(read, *axis.dimension);
    return {unit.in_si, axis.title + " [" + std::string(unit.name) + "]"};
}

std::string range_of(const Axis& axis, const Scale& scale, const Extent& extent) {
    const auto bound = [&](const std::optional<double>& value) { return value ? num(scale(*value)) : "*"; };
    std::string low = bound(axis.min);
    // A linear axis shows its zero, so that heights can be compared.
    if (!axis.min && !axis.logarithmic && extent.low >= 0.0 && !extent.empty) low = "0";
    std::string high = bound(axis.max);
    if (!axis.max && extent.high <= 0.0 && !axis.logarithmic) high = "1";
    return "[" + low + ":" + high + "]";
}

std::string axis_commands(std::string_view name, const Axis& axis, const Scale& scale, const Extent& extent) {
    const std::string n(name);
    std::string out = "set " + n + "label " + quoted(scale.title) + "\n";
    out += (axis.logarithmic ? "set logscale " : "unset logscale ") + n + "\n";
    out += "set " + n + "range " + range_of(axis, scale, extent) + "\n";
    if (axis.names.empty()) return out + "set " + n + "tics nomirror autofreq\n";
    std::string tics;
    for (const auto& [value, text] : axis.names) {
        tics += (tics.empty() ? "" : ", ") + quoted(text) + " " + num(scale(value));
    }
    return out + "set " + n + "tics nomirror (" + tics + ")\n";
}

std::string data_block(const Series& series, const Scale& x, const Scale& y, std::size_t number) {
    std::string out = "$data" + std::to_string(number) + " << END\n";
    for (std::size_t i = 0; i < series.x.size(); ++i) {
        if (!std::isfinite(series.x[i]) || !std::isfinite(series.y[i])) {
            out += "\n";
            continue;
        }
        out += num(x(series.x[i])) + " " + num(y(series.y[i]));
        if (!series.error.empty()) out += " " + num(y(series.error[i]));
        out += "\n";
    }
    return out + "END\n";
}

bool drawable(const Series& series) {
    for (std::size_t i = 0; i < series.x.size(); ++i) {
        if (std::isfinite(series.x[i]) && std::isfinite(series.y[i])) return true;
    }
    return false;
}

std::string looks(const Series& series) {
    const std::size_t index = static_cast<std::size_t>(series.style) % styles.size();
    const LineStyle& style = styles[index];
    const std::string color = "lc rgb '" + std::string(style.color) + "'";
    const std::string dash = " dt " + std::string(style.dash);
    const std::string point = " pt " + std::to_string(style.point) + " ps 0.9";
    switch (series.mark) {
        case Mark::line:
            return "with lines " + color + " lw 2.2" + dash;
        case Mark::line_points:
            return "with linespoints " + color + " lw 2.2" + dash + point;
        case Mark::points:
            return (series.error.empty() ? "with points " : "with yerrorbars ") + color + " lw 1.6" + point;
        case Mark::outline:
            return "with filledcurves closed " + color + " lw 2" + dash +
                   " fs transparent solid 0.12 border lc rgb '" + std::string(style.color) + "'";
        case Mark::faint:
            return "with lines lc rgb '" + std::string(grey) + "' lw 1.1 dt solid";
        case Mark::wall:
            return "with filledcurves closed lc rgb '#c8c8c8' fs solid 1.0 border lc rgb '" +
                   std::string(grey) + "'";
    }
    return "with lines";
}

/// @param pixels  of the picture in its own size
double font_size(Canvas canvas, double pixels) {
    constexpr double points_a_pixel = 0.75;
    return canvas == Canvas::svg ? pixels : pixels * points_a_pixel;
}

class PanelScript {
  public:
    PanelScript(const Panel& panel, Canvas canvas)
        : panel_(panel),
          canvas_(canvas),
          x_extent_(extent_of(panel, true)),
          y_extent_(extent_of(panel, false)),
          x_(scale_of(panel.x, x_extent_)),
          y_(scale_of(panel.y, y_extent_)) {
        if (panel.one_scale) {
            y_ = x_;
            y_.title = scale_of(panel.y, x_extent_).title;
        }
    }

    /// Lines the key takes above the panel.
    [[nodiscard]] int key_lines() const {
        const int entries = static_cast<int>(titles().size());
        return (entries + key_columns() - 1) / key_columns();
    }

    /// @param lines  of the highest key in the row, so that the panels beside each other are level
    [[nodiscard]] std::string text(int lines) const {
        std::string out = "unset label\nunset arrow\nunset object\n" + head(lines);
        out += axis_commands("x", panel_.x, x_, x_extent_) + axis_commands("y", panel_.y, y_, y_extent_);
        out += panel_.one_scale ? "set size ratio -1\n" : "set size noratio\n";
        out += marks();
        std::string plot;
        std::string blocks;
        for (std::size_t i = 0; i < panel_.series.size(); ++i) {
            const Series& series = panel_.series[i];
            if (!drawable(series)) continue;
            blocks += data_block(series, x_, y_, i);
            plot += (plot.empty() ? "plot " : ", \\\n     ") + std::string("$data") + std::to_string(i) +
                    " " + looks(series) +
                    (series.title.empty() ? " notitle" : " title " + quoted(series.title));
        }
        return out + blocks + (plot.empty() ? "plot [0:1] [0:1] NaN notitle" : plot) + "\n";
    }

  private:
    [[nodiscard]] std::vector<std::string_view> titles() const {
        std::vector<std::string_view> found;
        for (const Series& series : panel_.series) {
            if (!series.title.empty() && drawable(series)) found.push_back(series.title);
        }
        return found;
    }

    [[nodiscard]] int key_columns() const {
        const std::vector<std::string_view> entries = titles();
        const bool wide = std::any_of(entries.begin(), entries.end(),
                                      [](std::string_view text) { return text.size() > narrow_key; });
        return wide || canvas_ == Canvas::terminal ? 1 : 2;
    }

    /// Title and key above the panel, where they hide nothing.
    [[nodiscard]] std::string head(int lines) const {
        if (canvas_ == Canvas::terminal) {
            return "set title " + quoted(panel_.title) + "\n" +
                   (titles().empty() ? "unset key\n"
                                     : "set key tmargin left Left reverse samplen 3 maxcols 1\n");
        }
        constexpr double line = 1.1;  // character heights
        const double margin = line * lines + (panel_.title.empty() ? 1.0 : 2.4);
        std::string out = "set tmargin " + num(margin) + "\n";
        if (!panel_.title.empty()) {
            out += "set label " + quoted(panel_.title) + " at graph 0, graph 1 offset 0," +
                   num(margin - 1.0) + " left font '," + num(font_size(canvas_, 14.0)) + "'\n";
        }
        if (titles().empty()) return out + "unset key\n";
        return out +
               "set key at graph 0, graph 1.01 left bottom Left reverse samplen 3.2 spacing 1.05 maxrows " +
               std::to_string(key_lines()) + "\n";
    }

    [[nodiscard]] std::string marks() const {
        std::string out;
        for (const double x : panel_.verticals) {
            out += "set arrow from first " + num(x_(x)) + ", graph 0 to first " + num(x_(x)) +
                   ", graph 1 nohead lc rgb '" + std::string(grey) + "' lw 1 dt solid back\n";
        }
        for (const Circle& circle : panel_.circles) {
            out += "set object circle at first " + num(x_(circle.x)) + ", graph " + num(circle.height) +
                   " size first " + num(x_(circle.radius)) + " fs transparent solid 0.12 border lc rgb '" +
                   std::string(styles[2].color) + "' fc rgb '" + std::string(styles[2].color) + "' back\n";
        }
        for (const PictureLabel& label : panel_.labels) {
            const char* const side = label.anchor == Anchor::left    ? " left"
                                     : label.anchor == Anchor::right ? " right"
                                                                     : " center";
            out += "set label " + quoted(label.text) + " at first " + num(x_(label.x)) + ", first " +
                   num(y_(label.y)) + side + " tc rgb '#333333' front\n";
        }
        return out;
    }

    const Panel& panel_;
    Canvas canvas_;
    Extent x_extent_;
    Extent y_extent_;
    Scale x_;
    Scale y_;
};

int height_of(const Picture& picture) {
    int height = picture.title.empty() ? 0 : title_height;
    for (const PictureRow& row : picture.rows) height += row.height;
    return height;
}

std::string terminal_command(const Picture& picture, Canvas canvas, const CanvasSize& size) {
    const auto pixels = [&](int factor) {
        return std::to_string(factor * picture_width) + "," + std::to_string(factor * height_of(picture));
    };
    constexpr double pixels_an_inch = 96.0;
    switch (canvas) {
        case Canvas::svg:
            return "set terminal svg noenhanced size " + pixels(1) +
                   " font 'sans-serif,13' background rgb 'white' name " + quoted(picture.name) + "\n";
        case Canvas::png:
            return "set terminal pngcairo noenhanced size " + pixels(2) +
                   " fontscale 2 linewidth 2 pointscale 2 font 'Sans,9.75' background rgb 'white'\n";
        case Canvas::pdf:
            return "set terminal pdfcairo noenhanced size " + num(picture_width / pixels_an_inch) + "in," +
                   num(height_of(picture) / pixels_an_inch) +
                   "in fontscale 1 font 'Sans,9.75' background rgb 'white'\n";
        case Canvas::terminal:
            return "set terminal dumb noenhanced nofeed mono size " + std::to_string(size.columns) + "," +
                   std::to_string(size.lines) + "\n";
    }
    return {};
}

}  // namespace

std::span<const LineStyle> house_styles() {
    return styles;
}

std::string gnuplot_script(const Picture& picture, Canvas canvas, const CanvasSize& size) {
    const bool terminal = canvas == Canvas::terminal;
    std::string out = "set encoding utf8\n" + terminal_command(picture, canvas, size);
    out += "set border 3 lw 1 lc rgb '#444444'\nset tics nomirror out scale 0.6\n";
    if (!terminal) {
        out +=
            "set grid xtics ytics lc rgb '#e4e4e4' lw 0.8 dt solid\n"
            "set style fill transparent solid 0.12\nset multiplot\n";
        if (!picture.title.empty()) {
            out += "set label 1 " + quoted(picture.title) + " at screen 0.012, screen " +
                   num(1.0 - 0.55 * title_height / height_of(picture)) + " left font '," +
                   num(font_size(canvas, 15.0)) +
                   "'\nset origin 0,0\nset size 1,1\nunset border\nunset tics\n"
                   "unset key\nplot [0:1] [0:1] NaN notitle\nunset label 1\nset border 3\n"
                   "set tics nomirror out scale 0.6\n";
        }
    }
    const double total = height_of(picture);
    double below = total - (picture.title.empty() ? 0.0 : title_height);
    for (const PictureRow& row : picture.rows) {
        below -= row.height;
        const double width = 1.0 / static_cast<double>(row.panels.size());
        int key_lines = 0;
        for (const Panel& panel : row.panels) {
            key_lines = std::max(key_lines, PanelScript(panel, canvas).key_lines());
        }
        for (std::size_t i = 0; i < row.panels.size(); ++i) {
            const std::string panel = PanelScript(row.panels[i], canvas).text(key_lines);
            if (!terminal) {
                out += "set origin " + num(width * static_cast<double>(i)) + "," + num(below / total) +
                       "\nset size " + num(width) + "," + num(row.height / total) + "\n";
            }
            out += panel;
        }
    }
    return terminal ? out : out + "unset multiplot\n";
}

}  // namespace bioprint
