#include "io/gnuplot_script.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/axis_script.hpp"

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
constexpr int subtitle_height = 22;
constexpr double letter_width = 7.4;   ///< [px]
constexpr double key_sample = 62.0;    ///< of a key entry beside its text [px]
constexpr double panel_margin = 90.0;  ///< left and right of a panel [px]
constexpr double key_line = 1.1;       ///< character heights

std::string script_text(std::string_view text) {
    return gnuplot_text(text);
}

std::string num(double value) {
    return gnuplot_number(value);
}

double width_of(std::string_view text) {
    return static_cast<double>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// A bar that ends where a number ends that does not exist is none.
bool has_bars(const Series& series) {
    return series.low.size() == series.x.size() && series.high.size() == series.x.size() && !series.x.empty();
}

std::string data_block(const Series& series, const Scale& x, const Scale& y, std::size_t number) {
    std::string out = "$data" + std::to_string(number) + " << END\n";
    for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
        if (!std::isfinite(series.x[i]) || !std::isfinite(series.y[i])) {
            out += "\n";
            continue;
        }
        out += num(x(series.x[i])) + " " + num(y(series.y[i]));
        if (has_bars(series)) {
            const auto end = [&](double value) { return num(y(std::isfinite(value) ? value : series.y[i])); };
            out += " " + end(series.low[i]) + " " + end(series.high[i]);
        }
        out += "\n";
    }
    return out + "END\n";
}

bool drawable(const Series& series) {
    for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
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
    if (has_bars(series) && series.mark != Mark::band) return "with yerrorbars " + color + " lw 1.6" + point;
    switch (series.mark) {
        case Mark::line:
            return "with lines " + color + " lw 2.2" + dash;
        case Mark::line_points:
            return "with linespoints " + color + " lw 2.2" + dash + point;
        case Mark::points:
            return "with points " + color + " lw 1.6" + point;
        case Mark::crosses:
            return "with points lc rgb '" + std::string(grey) + "' lw 1.4 pt 2 ps 0.8";
        case Mark::band:
            return "using 1:3:4 with filledcurves " + color + " fs transparent solid 0.18 noborder";
        case Mark::outline:
            return "with filledcurves closed " + color + " lw 2 dt solid" +
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
    /// @param width  [px]
    PanelScript(const Panel& panel, Canvas canvas, double width)
        : panel_(panel),
          canvas_(canvas),
          width_(width),
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
        // A point on the border would be cut in two by the eye.
        const bool room = y_extent_.has_points && !panel_.y.logarithmic;
        out += room ? "set offsets graph 0, 0, 0.05, 0\n" : "unset offsets\n";
        out += marks();
        std::string plot;
        std::string blocks;
        for (std::size_t i = 0; i < panel_.series.size(); ++i) {
            const Series& series = panel_.series[i];
            if (!drawable(series)) continue;
            // Letters in place of a light tint hide the curves.
            if (canvas_ == Canvas::terminal && series.mark == Mark::band) continue;
            blocks += data_block(series, x_, y_, i);
            const auto add = [&](const std::string& how, const std::string& title) {
                plot += (plot.empty() ? "plot " : ", \\\n     ") + std::string("$data") + std::to_string(i) +
                        " " + how + (title.empty() ? " notitle" : " title " + script_text(title));
            };
            // A bar is drawn through even where the line it stands on is dashed.
            if (has_bars(series) && (series.mark == Mark::line || series.mark == Mark::line_points)) {
                Series line = series;
                line.low.clear();
                line.mark = Mark::line;
                add(looks(line), "");
            }
            add(draws_as_letters(series) ? "with points pt 15" : looks(series), series.title);
        }
        return out + blocks + (plot.empty() ? "plot [0:1] [0:1] NaN notitle" : plot) + "\n";
    }

  private:
    /// Characters have seven kinds of lines; where more cross, one that is named in the key stands out by letters.
    [[nodiscard]] bool draws_as_letters(const Series& series) const {
        constexpr auto terminal_lines = 7;
        const auto is_line = [](const Series& s) {
            return (s.mark == Mark::line || s.mark == Mark::faint) && drawable(s);
        };
        return canvas_ == Canvas::terminal && series.mark == Mark::line && !series.title.empty() &&
               std::count_if(panel_.series.begin(), panel_.series.end(), is_line) > terminal_lines;
    }

    [[nodiscard]] std::vector<std::string_view> titles() const {
        std::vector<std::string_view> found;
        for (const Series& series : panel_.series) {
            if (!series.title.empty() && drawable(series)) found.push_back(series.title);
        }
        return found;
    }

    /// As many entries beside each other as there is room for.
    [[nodiscard]] int key_columns() const {
        if (canvas_ == Canvas::terminal) return 1;
        double widest = 0.0;
        for (const std::string_view text : titles()) widest = std::max(widest, width_of(text));
        constexpr int most = 4;
        return std::clamp(static_cast<int>((width_ - panel_margin) / (key_sample + letter_width * widest)), 1,
                          most);
    }

    /// Title and key above the panel, where they hide nothing.
    [[nodiscard]] std::string head(int lines) const {
        if (canvas_ == Canvas::terminal) {
            // Characters have no turned axis title; the unit must not get lost with it.
            const std::string title = panel_.title + (panel_.title.empty() ? "" : ": ") + y_.title;
            return "set title " + script_text(title) + "\n" +
                   (titles().empty() ? "unset key\n"
                                     : "set key tmargin left Left reverse samplen 3 maxcols 1\n");
        }
        const double title = panel_.title.empty() ? 1.0 : 2.4;
        std::string out = "set tmargin " + num(key_line * lines + title) + "\n";
        if (!panel_.title.empty()) {
            out += "set label " + script_text(panel_.title) + " at graph 0, graph 1 offset 0," +
                   num(key_line * key_lines() + title - 1.0) + " left font '," +
                   num(font_size(canvas_, 14.0)) + "'\n";
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
            if (canvas_ == Canvas::terminal) break;  // letters in place of a light tint hide the curve
            out += "set object circle at first " + num(x_(circle.x)) + ", graph " + num(circle.height) +
                   " size first " + num(x_(circle.radius)) + " fs transparent solid 0.12 border lc rgb '" +
                   std::string(styles[2].color) + "' fc rgb '" + std::string(styles[2].color) + "' back\n";
        }
        for (const PictureLabel& label : panel_.labels) {
            const char* const side = label.anchor == Anchor::left    ? " left"
                                     : label.anchor == Anchor::right ? " right"
                                                                     : " center";
            out += "set label " + script_text(label.text) + " at first " + num(x_(label.x)) + ", first " +
                   num(y_(label.y)) + side + " tc rgb '#333333' front\n";
        }
        return out;
    }

    const Panel& panel_;
    Canvas canvas_;
    double width_;
    Extent x_extent_;
    Extent y_extent_;
    Scale x_;
    Scale y_;
};

int head_height(const Picture& picture) {
    if (picture.title.empty()) return 0;
    return title_height + (picture.subtitle.empty() ? 0 : subtitle_height);
}

int height_of(const Picture& picture) {
    int height = head_height(picture);
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
                   " font 'sans-serif,13' background rgb 'white' name " + script_text(picture.name) + "\n";
        case Canvas::png:
            return "set terminal pngcairo noenhanced size " + pixels(2) +
                   " fontscale 2 linewidth 2 pointscale 2 font 'Sans,9.75' background rgb 'white'\n";
        case Canvas::pdf:
            return "set terminal pdfcairo noenhanced size " + num(picture_width / pixels_an_inch) + "in," +
                   num(height_of(picture) / pixels_an_inch) +
                   "in fontscale 0.75 font 'Sans,9.75' background rgb 'white'\n";
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
            const auto line = [&](const char* number, const std::string& text, double below, double pixels) {
                return "set label " + std::string(number) + " " + script_text(text) +
                       " at screen 0.012, screen " + num(1.0 - below / height_of(picture)) + " left font '," +
                       num(font_size(canvas, pixels)) + "' tc rgb '#222222'\n";
            };
            out += line("1", picture.title, 0.55 * title_height, 15.0);
            if (!picture.subtitle.empty()) {
                out += line("2", picture.subtitle, title_height + 0.35 * subtitle_height, 12.5);
            }
            out +=
                "set origin 0,0\nset size 1,1\nunset border\nunset tics\n"
                "unset key\nplot [0:1] [0:1] NaN notitle\nunset label\nset border 3\n"
                "set tics nomirror out scale 0.6\n";
        }
    }
    // Left to itself gnuplot makes room for the numbers of each axis.
    if (picture.one_x && !terminal) out += "set lmargin at screen 0.09\nset rmargin at screen 0.975\n";
    const double total = height_of(picture);
    double below = total - head_height(picture);
    for (const PictureRow& row : picture.rows) {
        below -= row.height;
        const double width = 1.0 / static_cast<double>(row.panels.size());
        int key_lines = 0;
        for (const Panel& panel : row.panels) {
            key_lines = std::max(key_lines, PanelScript(panel, canvas, width * picture_width).key_lines());
        }
        for (std::size_t i = 0; i < row.panels.size(); ++i) {
            const std::string panel =
                PanelScript(row.panels[i], canvas, width * picture_width).text(key_lines);
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
