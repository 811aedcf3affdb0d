// SPDX-License-Identifier: MIT
#include "io/picture/vector/pdf_writer.h"

#include "document/fractal/fractal_geometry.h"
#include "io/overlay/pdf_overlay.h"
#include "io/picture/vector/pdf_file.h"
#include "io/picture/vector/svg_shapes.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace io {

namespace {

constexpr int deepestNest = 10; // nested forms; viewers give up beyond some 30

QByteArray text(double number) {
    return pdfNumber(number);
}

QByteArray text(const ifs::Vector<2>& point) {
    return text(point.x()) + ' ' + text(point.y());
}

// Column by column, as in SVG.
QByteArray text(const ifs::AffineMap<2>& map) {
    const auto& m = map.linear;
    QByteArrayList numbers;
    for (const double number : {m(0, 0), m(1, 0), m(0, 1), m(1, 1), map.translation.x(), map.translation.y()})
        numbers << text(number);
    return numbers.join(' ');
}

QByteArray text(const attractor::Rgba& colour) {
    const auto share = [](std::uint8_t channel) { return text(std::round(channel / 0.255) / 1000); };
    return share(colour.red) + ' ' + share(colour.green) + ' ' + share(colour.blue);
}

// A thousandth of a pixel is finer than any printer.
ifs::Vector<2> rounded(const ifs::Vector<2>& pixel) {
    return {std::round(pixel.x() * 1000) / 1000, std::round(pixel.y() * 1000) / 1000};
}

QByteArray ringPath(const Ring& ring) {
    QByteArray path;
    for (const auto& point : ring)
        path += text(point) + (path.isEmpty() ? " m\n" : " l\n");
    return path + "h\n";
}

Ring mapped(const ifs::AffineMap<2>& map, Ring ring) {
    for (auto& point : ring)
        point = map(point);
    return ring;
}

// The forms of a structured picture. A form makes its copies from forms some levels below, not always from
// the next ones, so that the nest stays flat.
class Forms {
public:
    Forms(PdfFile& file, const ifs::CopyHierarchy& levels, int depth)
        : m_file(file), m_levels(levels), m_depth(depth), m_stride((depth + deepestNest - 1) / deepestNest) {}

    QByteArray drawn(const ifs::Copy& copy) {
        if (!copy.projection) return copyOf(form(copy.level), copy.map);
        QByteArray content;
        for (const Ring& bar : m_levels.projection(*copy.projection)->bars)
            content += ringPath(mapped(copy.map, bar)) + "f\n";
        return content;
    }
    QByteArray list() const { // names and objects
        QByteArray list;
        for (const auto& [level, form] : m_forms)
            list += "/L" + QByteArray::number(level) + ' ' + pdfReference(form.object);
        return list;
    }

private:
    struct Form {
        int level = 0;
        int object = 0;
        ifs::Vector<2> low = ifs::Vector<2>::Constant(HUGE_VAL);
        ifs::Vector<2> high = ifs::Vector<2>::Constant(-HUGE_VAL);

        void include(const ifs::Vector<2>& point) {
            low = low.cwiseMin(point);
            high = high.cwiseMax(point);
        }
    };

    static QByteArray copyOf(const Form& form, const ifs::AffineMap<2>& map) {
        return "q " + text(map) + " cm /L" + QByteArray::number(form.level) + " Do Q\n";
    }

    const Form& form(int level) {
        if (const auto known = m_forms.find(level); known != m_forms.end()) return known->second;
        Form made;
        made.level = level;
        QByteArray content;
        std::map<int, int> used;
        if (level == 0) {
            const Ring outline = m_levels.outline(m_depth);
            for (const auto& point : outline)
                made.include(point);
            content = ringPath(outline) + "f\n";
        } else {
            appendCopies(level, {}, std::max(0, level - m_stride), content, used, made);
        }
        QByteArray list;
        for (const auto& [below, object] : used)
            list += "/L" + QByteArray::number(below) + ' ' + pdfReference(object);
        made.object = m_file.addStream("/Type/XObject/Subtype/Form/BBox[" + text(made.low) + ' ' +
                                           text(made.high) + "]/Resources<</XObject<<" + list + ">>>>",
                                       content);
        return m_forms[level] = made;
    }

    void appendCopies(int level, const ifs::AffineMap<2>& outer, int floor, QByteArray& content,
                      std::map<int, int>& used, Form& made) {
        for (const ifs::Copy& copy : m_levels.copies(level, m_depth)) {
            const int below = copy.level;
            const ifs::AffineMap<2> map = outer * copy.map;
            if (copy.projection) {
                for (const Ring& bar : m_levels.projection(*copy.projection)->bars) {
                    const Ring moved = mapped(map, bar);
                    for (const auto& point : moved)
                        made.include(point);
                    content += ringPath(moved) + "f\n";
                }
                continue;
            }
            if (below > floor) {
                appendCopies(below, map, floor, content, used, made);
                continue;
            }
            const Form& copied = form(below);
            used[below] = copied.object;
            content += copyOf(copied, map);
            for (const double x : {copied.low.x(), copied.high.x()})
                for (const double y : {copied.low.y(), copied.high.y()})
                    made.include(map(ifs::Vector<2>(x, y)));
        }
    }

    PdfFile& m_file;
    const ifs::CopyHierarchy& m_levels;
    int m_depth;
    int m_stride;
    std::map<int, Form> m_forms;
};

class PageWriter {
public:
    PageWriter(PdfFile& file, const PdfPage& page) : m_file(file), m_page(page) {}

    void write(const ifs::CopyHierarchy& levels, int depth, const std::stop_token& stop) {
        const auto& [fractal, camera, format] = m_page;
        const double pointsPerPixel = 72 / format.dotsPerInch;
        QByteArray resources;
        m_content = text(pointsPerPixel) + " 0 0 " + text(-pointsPerPixel) + " 0 " +
                    text(pointsPerPixel * camera.height) + " cm\n";
        if (format.style != ShapeStyle::Outline) addBackground();
        if (format.style == ShapeStyle::Structured)
            resources = addCopies(levels, depth);
        else if (format.style == ShapeStyle::Outline)
            addOutline(leafUnion(levels, depth, stop));
        else
            resources = addPoints();
        if (format.cage == CageVisibility::Shown) resources += addCage(groundOf(fractal, format));
        if (format.overlay != PictureOverlay()) {
            const OverlayMarks marks = overlayMarks(fractal, camera, format.overlay);
            m_content += pdfMarks(marks);
            resources += pdfMarkResources(marks);
        }
        const int content = m_file.addStream({}, m_content);
        m_file.addPage("/MediaBox[0 0 " + text(pointsPerPixel * camera.width) + ' ' +
                       text(pointsPerPixel * camera.height) + "]/Resources<<" + resources + ">>/Contents " +
                       pdfReference(content));
    }

private:
    void addBackground() {
        const attractor::Rgba& colour = m_page.fractal.appearance.background;
        if (colour.alpha == 0) return;
        m_content += text(colour) + " rg 0 0 " + text(double(m_page.camera.width)) + ' ' +
                     text(double(m_page.camera.height)) + " re f\n";
    }

    // Contents of the resource dictionary without its brackets, as from the functions below.
    QByteArray addCopies(const ifs::CopyHierarchy& levels, int depth) {
        Forms forms(m_file, levels, depth);
        const auto shadow = shapeShadow(m_page.fractal, m_page.camera);
        const QByteArray behind =
            shadow ? copies(shadow->fractal, shadow->map * levels.display(), levels, depth, forms)
                   : QByteArray();
        const QByteArray front = copies(m_page.fractal, levels.display(), levels, depth, forms);
        QByteArray list = forms.list();
        if (shadow) list += addShadow(behind, "/XObject<<" + list + ">>");
        m_content += front;
        return "/XObject<<" + list + ">>";
    }

    static QByteArray copies(const document::Fractal& fractal, const ifs::AffineMap<2>& display,
                             const ifs::CopyHierarchy& levels, int depth, Forms& forms) {
        const attractor::Rgba all = shapeColour(fractal.appearance);
        QByteArray content = "q " + text(display) + " cm\n" + text(all) + " rg\n";
        for (const ifs::Copy& copy : levels.picture(depth)) {
            content += text(shapeColour(fractal, levels, copy).value_or(all)) + " rg\n";
            content += forms.drawn(copy);
        }
        return content + "Q\n";
    }

    // Adds a single transparent group, so that overlapping parts are not darker.
    QByteArray addShadow(const QByteArray& content, const QByteArray& resources) {
        const int object =
            m_file.addStream("/Type/XObject/Subtype/Form/BBox[0 0 " + text(double(m_page.camera.width)) +
                                 ' ' + text(double(m_page.camera.height)) +
                                 "]/Group<</S/Transparency>>/Resources<<" + resources + ">>",
                             content);
        const int state = m_file.addStream(
            "/Type/XObject/Subtype/Form/BBox[0 0 " + text(double(m_page.camera.width)) + ' ' +
                text(double(m_page.camera.height)) + "]/Resources<</ExtGState<</Shade<</ca " +
                text(m_page.fractal.appearance.shadow) + ">>>>/XObject<</Shapes " + pdfReference(object) +
                ">>>>",
            "/Shade gs /Shapes Do\n");
        m_content += "q /Shadow Do Q\n";
        return "/Shadow " + pdfReference(state);
    }

    void addOutline(const std::vector<Ring>& rings) {
        m_content += "0 G 1 w 1 j\n";
        for (Ring ring : rings) {
            std::transform(ring.begin(), ring.end(), ring.begin(), rounded);
            m_content += ringPath(ring);
        }
        m_content += "S\n";
    }

    QByteArray addPoints() {
        const auto shadow = shapeShadow(m_page.fractal, m_page.camera);
        QByteArray resources;
        if (shadow) resources = "/XObject<<" + addShadow(points(shadow->fractal), {}) + ">>";
        m_content += points(m_page.fractal);
        return resources;
    }

    QByteArray points(const document::Fractal& fractal) const {
        const SvgFormat& format = m_page.format;
        QByteArray content = "1 w 1 J\n"; // round ends: a line without length is a dot
        for (const ColouredPoints& group : shapePoints(fractal, m_page.camera, format.points, format.seed)) {
            content += text(group.colour) + " RG\n";
            for (const auto& point : group.points) {
                const QByteArray position = text(rounded(point));
                content += position + " m " + position + " l\n";
            }
            content += "S\n";
        }
        return content;
    }

    QByteArray addCage(const attractor::Rgba& ground) {
        const ifs::ControlCage<2> cage = document::effectiveCage(m_page.fractal);
        const QColor colour = inkOn(ground);
        m_content += text(attractor::Rgba{std::uint8_t(colour.red()), std::uint8_t(colour.green()),
                                          std::uint8_t(colour.blue()), 255}) +
                     " RG 1.5 w 1 j\n";
        m_content += polygon(cage.current) + "S\n";
        const OverlayMarks corners = cornerMarks(m_page.fractal, m_page.camera, ground);
        m_content += pdfMarks(corners);
        return pdfMarkResources(corners);
    }

    QByteArray polygon(Ring vertices) const {
        for (auto& vertex : vertices)
            vertex = toPixel(m_page.camera, vertex);
        return ringPath(vertices);
    }

    PdfFile& m_file;
    const PdfPage& m_page;
    QByteArray m_content;
};

} // namespace

Failure addPage(PdfFile& file, const PdfPage& page, const std::stop_token& stop) {
    const ShapeLevels levels = shapeLevels(page.fractal, page.camera);
    if (levels.failure) return levels.failure;
    PageWriter(file, page).write(*levels.levels, svgDepth(*levels.levels, page.format), stop);
    return std::nullopt;
}

PdfPicture pdfPicture(const std::vector<PdfPage>& pages, const std::stop_token& stop) {
    PdfFile file;
    for (const PdfPage& page : pages) {
        if (const Failure failure = addPage(file, page, stop)) return {{}, failure};
        if (stop.stop_requested()) return {};
    }
    return {file.bytes(pages.empty() ? QString() : pages.front().fractal.name), {}};
}

} // namespace io
