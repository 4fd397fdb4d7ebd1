// Motions in files: tables, grids for ParaView, and time series for it.

#include <algorithm>
#include <cmath>
#include <utility>

#include "harmonic_field.hpp"
#include "printing.hpp"
#include "stepped_bar.hpp"

namespace signorini {

namespace {

std::vector<double> inUnits(const std::vector<std::int64_t>& counts, double unit)
{
    std::vector<double> values;
    values.reserve(counts.size());
    for (const std::int64_t count : counts) {
        values.push_back(static_cast<double>(count) * unit);
    }
    return values;
}

/// One .vtu file of cells in a strip: columns of two points each, joined to quadrangles.
class Strip {
public:
    Strip(const std::string& path, std::size_t cells) : file_(path), cells_(cells)
    {
        print(file_,
              "<?xml version=\"1.0\"?>\n"
              "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
              "<UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
              2 * (cells + 1), cells);
    }

    void open(const char* section) { print(file_, "<{}>\n", section); }
    void close(const char* section) { print(file_, "</{}>\n", section); }

    /// A value for each cell.
    template <typename Value>
    void scalars(const char* name, Value value)
    {
        print(file_, "<DataArray type=\"Float64\" Name=\"{}\" format=\"ascii\">\n", name);
        for (std::size_t cell = 0; cell < cells_; ++cell) {
            print(file_, "{}\n", value(cell));
        }
        close("DataArray");
    }

    /// A vector for each column of points, the same for both but for its y.
    template <typename Value>
    void vectors(const char* name, double lowY, double highY, Value x)
    {
        print(file_,
              "<DataArray type=\"Float64\" Name=\"{}\" NumberOfComponents=\"3\" "
              "format=\"ascii\">\n",
              name);
        for (std::size_t column = 0; column <= cells_; ++column) {
            print(file_, "{0} {1} 0\n{0} {2} 0\n", x(column), lowY, highY);
        }
        close("DataArray");
    }

    /// Quadrangles and the end of the file.
    void finish()
    {
        open("Cells");
        print(file_, "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n");
        for (std::size_t cell = 0; cell < cells_; ++cell) {
            print(file_, "{} {} {} {}\n", 2 * cell, 2 * cell + 2, 2 * cell + 3, 2 * cell + 1);
        }
        print(file_,
              "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n");
        for (std::size_t cell = 0; cell < cells_; ++cell) {
            print(file_, "{}\n", 4 * (cell + 1));
        }
        constexpr int quadrangle = 9;  // VTK_QUAD
        print(file_, "</DataArray>\n<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">\n");
        for (std::size_t cell = 0; cell < cells_; ++cell) {
            print(file_, "{}\n", quadrangle);
        }
        print(file_, "</DataArray>\n</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
        file_.close();
    }

private:
    TextFile file_;
    std::size_t cells_;
};

constexpr double heightShare = 0.05;  ///< of the bar's length

void writeBar(const std::string& path, const MotionSamples& samples, std::size_t instant)
{
    const double half = 0.5 * heightShare * samples.bar().length;
    Strip strip(path, samples.nodes() - 1);
    const auto u = [&](std::size_t node) { return samples.displacement(node, instant); };
    strip.open("PointData");
    strip.vectors("displacement", 0.0, 0.0, u);
    strip.close("PointData");
    strip.open("CellData");
    strip.scalars("velocity",
                  [&](std::size_t cell) { return samples.velocity(cell + 1, instant); });
    strip.scalars("strain", [&](std::size_t cell) { return samples.strain(cell + 1, instant); });
    strip.scalars("force", [&](std::size_t cell) { return samples.force(cell + 1, instant); });
    strip.close("CellData");
    strip.open("Points");
    strip.vectors("points", -half, half,
                  [&](std::size_t node) { return samples.x(node) + u(node); });
    strip.close("Points");
    strip.finish();
}

void writeWall(const std::string& path, const Bar& bar)
{
    const double height = heightShare * bar.length;
    Strip strip(path, 1);
    strip.open("PointData");
    strip.vectors("displacement", 0.0, 0.0, [&](std::size_t) { return bar.gap; });
    strip.close("PointData");
    strip.open("CellData");
    for (const char* name : {"velocity", "strain", "force"}) {
        strip.scalars(name, [](std::size_t) { return 0.0; });
    }
    strip.close("CellData");
    strip.open("Points");
    strip.vectors("points", -height, height, [&](std::size_t column) {
        return bar.length + bar.gap + static_cast<double>(column) * 0.5 * height;
    });
    strip.close("Points");
    strip.finish();
}

/// The characters that XML does not take as they are.
std::string inXml(const std::string& text)
{
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

/// The middle of the cell that ends at each node, at the clamp of the first one.
std::vector<double> middlesOf(const std::vector<std::int64_t>& nodes, double cell)
{
    std::vector<double> middles;
    middles.reserve(nodes.size());
    for (const std::int64_t node : nodes) {
        middles.push_back((static_cast<double>(std::max<std::int64_t>(node, 1)) - 0.5) * cell);
    }
    return middles;
}

/// EA of the cell that ends at each node, relative to the first: Z = EA/c.
std::vector<double> stiffnessAt(const std::vector<std::int64_t>& nodes,
                                const std::vector<Segment>& segments)
{
    const SteppedBar bar = steppedBar(segments);
    std::vector<double> values;
    std::size_t segment = 0;
    std::int64_t end = bar.segments.front().cells;
    for (const std::int64_t node : nodes) {
        while (node > end && segment + 1 < bar.segments.size()) {
            end += bar.segments[++segment].cells;
        }
        values.push_back(bar.segments[segment].impedance * bar.segments[segment].speed);
    }
    return values;
}

}  // namespace

MotionSamples::MotionSamples(const Motion& motion, const Scene& scene, std::int64_t mostInstants)
    : scene_(scene)
{
    const Bar& bar = scene.bar;
    const auto cells = static_cast<double>(motion.cells());
    const std::vector<std::int64_t> nodes = thinned(motion.cells(), maxMotionNodes);
    const std::vector<std::int64_t> instants = thinned(motion.steps(), mostInstants);
    x_ = inUnits(nodes, bar.length / cells);
    xCell_ = middlesOf(nodes, bar.length / cells);
    times_ = inUnits(instants, scales(bar).time / cells);
    displacement_ = [&motion, nodes, instants](std::size_t i, std::size_t m) {
        return motion.displacement(nodes[i], instants[m]);
    };
    velocity_ = [&motion, nodes, instants](std::size_t i, std::size_t m) {
        return motion.velocity(std::max<std::int64_t>(nodes[i], 1), instants[m]);
    };
    strain_ = [&motion, nodes, instants](std::size_t i, std::size_t m) {
        return motion.strain(std::max<std::int64_t>(nodes[i], 1), instants[m]);
    };
    if (!isUniform(scene.segments)) {
        stiffness_ = stiffnessAt(nodes, scene.segments);
    }
}

/// u, v and s as functions of x and t, in units of scales(bar).
template <typename Functions>
void MotionSamples::sample(const Functions& motion, std::int64_t cells, std::int64_t mostInstants)
{
    const Bar& bar = scene_.bar;
    const std::vector<std::int64_t> counts = thinned(cells, maxMotionNodes);
    const std::vector<double> nodes = inUnits(counts, 1.0 / static_cast<double>(cells));
    const std::vector<double> middles = middlesOf(counts, 1.0 / static_cast<double>(cells));
    // As many steps as the grid would make, of equal length.
    const double steps = std::max(1.0, std::round(motion.period() * static_cast<double>(cells)));
    const std::vector<double> instants =
        inUnits(thinned(static_cast<std::int64_t>(steps), mostInstants), motion.period() / steps);
    x_ = inUnits(counts, bar.length / static_cast<double>(cells));
    xCell_ = middlesOf(counts, bar.length / static_cast<double>(cells));
    for (const double t : instants) {
        times_.push_back(t * scales(bar).time);
    }
    displacement_ = [&motion, nodes, instants](std::size_t i, std::size_t m) {
        return motion.displacement(nodes[i], instants[m]);
    };
    velocity_ = [&motion, middles, instants](std::size_t i, std::size_t m) {
        return motion.velocity(middles[i], instants[m]);
    };
    strain_ = [&motion, middles, instants](std::size_t i, std::size_t m) {
        return motion.strain(middles[i], instants[m]);
    };
}

MotionSamples::MotionSamples(const ModeMotion& motion, const Bar& bar, std::int64_t cells,
                             std::int64_t mostInstants)
    : scene_(bar)
{
    sample(motion, cells, mostInstants);
}

MotionSamples::MotionSamples(const HarmonicField& motion, Scene scene, std::int64_t cells,
                             std::int64_t mostInstants)
    : scene_(std::move(scene))
{
    sample(motion, cells, mostInstants);
}

MotionSamples::MotionSamples(BarsSampled sampled)
    : scene_(Bar{.gap = 1.0}),
      x_(std::move(sampled.x)),
      xCell_(std::move(sampled.xCell)),
      times_(std::move(sampled.times))
{
    const auto at = [count = x_.size()](std::vector<double> values) {
        return [count, values = std::move(values)](std::size_t node, std::size_t instant) {
            return values[instant * count + node];
        };
    };
    displacement_ = at(std::move(sampled.displacements));
    velocity_ = at(std::move(sampled.velocities));
    strain_ = at(std::move(sampled.strains));
}

double MotionSamples::displacement(std::size_t node, std::size_t instant) const
{
    return inUnit(displacement_(node, instant), scales(bar()).displacement);
}

double MotionSamples::force(std::size_t node, std::size_t instant) const
{
    const double relative = stiffness_.empty() ? 1.0 : stiffness_[node];
    return inUnit(strain(node, instant), bar().axialStiffness * relative);
}

double MotionSamples::velocity(std::size_t node, std::size_t instant) const
{
    return inUnit(velocity_(node, instant), scales(bar()).velocity);
}

double MotionSamples::strain(std::size_t node, std::size_t instant) const
{
    return inUnit(strain_(node, instant), scales(bar()).strain);
}

void writeMotionCsv(const std::string& path, const MotionSamples& samples)
{
    writeCsv(path, "time,x,displacement,velocity,strain,x_cell", [&samples](CsvRows& row) {
        for (std::size_t m = 0; m < samples.instants(); ++m) {
            for (std::size_t i = 0; i < samples.nodes(); ++i) {
                row(samples.time(m), samples.x(i), samples.displacement(i, m),
                    samples.velocity(i, m), samples.strain(i, m), samples.xCell(i));
            }
        }
    });
}

void writeMotionVtk(const std::string& path, const MotionSamples& samples)
{
    TextFile file(path);
    print(file,
          "# vtk DataFile Version 3.0\n"
          "signorini: motion of bars until it repeats; x in m along X, time in s along Y\n"
          "ASCII\nDATASET RECTILINEAR_GRID\nDIMENSIONS {} {} 1\n",
          samples.nodes(), samples.instants());
    print(file, "X_COORDINATES {} double\n", samples.nodes());
    for (std::size_t i = 0; i < samples.nodes(); ++i) {
        print(file, "{}\n", samples.x(i));
    }
    print(file, "Y_COORDINATES {} double\n", samples.instants());
    for (std::size_t m = 0; m < samples.instants(); ++m) {
        print(file, "{}\n", samples.time(m));
    }
    print(file, "Z_COORDINATES 1 double\n0\nPOINT_DATA {}\n", samples.nodes() * samples.instants());
    const auto writeField = [&](const char* name, auto value) {
        print(file, "SCALARS {} double 1\nLOOKUP_TABLE default\n", name);
        for (std::size_t m = 0; m < samples.instants(); ++m) {
            for (std::size_t i = 0; i < samples.nodes(); ++i) {
                print(file, "{}\n", (samples.*value)(i, m));
            }
        }
    };
    writeField("displacement", &MotionSamples::displacement);
    writeField("velocity", &MotionSamples::velocity);
    writeField("strain", &MotionSamples::strain);
    file.close();
}

void writeMotionSeries(const std::string& path, const std::string& folder, const std::string& name,
                       const MotionSamples& samples)
{
    TextFile file(path);
    print(file,
          "<?xml version=\"1.0\"?>\n"
          "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
          "<Collection>\n");
    const auto add = [&](std::size_t instant, int part, const std::string& member) {
        print(file, "<DataSet timestep=\"{}\" part=\"{}\" file=\"{}/{}\"/>\n",
              samples.time(instant), part, inXml(name), member);
    };
    writeWall(folder + "/wall.vtu", samples.bar());
    for (std::size_t m = 0; m < samples.instants(); ++m) {
        const std::string member = fmt::format("bar_{:04}.vtu", m);
        writeBar(fmt::format("{}/{}", folder, member), samples, m);
        add(m, 0, member);
        add(m, 1, "wall.vtu");
    }
    print(file, "</Collection>\n</VTKFile>\n");
    file.close();
}

}  // namespace signorini
