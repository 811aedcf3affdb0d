// SPDX-License-Identifier: MIT
#include "document/document.h"
#include "document/edits/cage/cage_actions.h"
#include "document/edits/cage/cage_edits.h"
#include "document/edits/dimension_edits.h"
#include "document/edits/entries_edits.h"
#include "document/edits/maps/link_edits.h"
#include "document/edits/maps/map_locks.h"
#include "document/edits/maps/maps_arrange.h"
#include "document/edits/maps/maps_edits.h"
#include "document/edits/maps/symmetry_edits.h"
#include "document/edits/timeline/animation_edits.h"
#include "document/edits/timeline/motion_edits.h"
#include "document/edits/transform_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "document/maps/map_handles.h"
#include "document/tops/kept_theft.h"
#include "io/fractint/fractint_reader.h"
#include "io/fractint/fractint_writer.h"
#include "support/complaints.h"
#include "support/named_test.h"
#include "support/paths.h"

#include <QDirIterator>
#include <QFile>
#include <QTest>

#include <QUndoStack>

#include <array>
#include <iterator>
#include <memory>
#include <random>

using document::Document;
using document::Fractal;

// Whatever is done to a file, in whatever order: it is in order, and reads as it was written.
// BARYCAGE_EDITS_ROUNDS: how many files, 40 without; BARYCAGE_EDITS_SEED: of the first; BARYCAGE_CORPUS: a
// folder of more.
class RandomEditsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void whatIsEditedIsReadAgain();

private:
    using Edit = void (RandomEditsTest::*)();

    int any(int count) { return int(m_random() % unsigned(std::max(count, 1))); }
    double anyIn(double low, double high) {
        return low + (high - low) * double(m_random()) / double(std::mt19937::max());
    }
    ifs::Vector<2> anyVector(double size) { return {anyIn(-size, size), anyIn(-size, size)}; }
    int mapCount() const {
        const auto* system = document::system2(m_document->fractal());
        return system ? int(system->maps.size()) : 0;
    }
    document::Rows anyRows() {
        document::Rows rows;
        for (int row = 0; row < mapCount(); ++row)
            if (any(3) == 0) rows.push_back(row);
        return rows;
    }
    void put(const char* text, Fractal after) {
        m_last = text;
        m_document->edit(QLatin1String(text), std::move(after));
    }
    void put(const char* text, std::optional<Fractal> after) {
        if (after) put(text, *std::move(after));
    }

    void open(unsigned seed);
    void step();
    void editMaps();
    void switchMap();
    void editWeights();
    void moveMaps();
    void moveBranch();
    void arrange();
    void moveCage();
    void changeCage();
    void fitCage();
    void link();
    void makeSymmetric();
    void transform();
    void transformInSpace();
    void changeDimension();
    void animate();
    void editKeys();
    void changeLook();
    void label();
    void editEntries();
    void steal();
    void travel();
    void save();

    QStringList m_files;
    std::mt19937 m_random;
    std::unique_ptr<Document> m_document;
    QByteArray m_last; // what was done
};

void RandomEditsTest::initTestCase() {
    for (const QString& folder : {support::sourcePath(QStringLiteral("ifs_library")), support::testData({}),
                                  qEnvironmentVariable("BARYCAGE_CORPUS")}) {
        if (folder.isEmpty()) continue;
        QDirIterator files(folder, {QStringLiteral("*.ifs")}, QDir::Files, QDirIterator::Subdirectories);
        while (files.hasNext())
            m_files << files.next();
    }
    m_files.sort();
    QVERIFY(!m_files.isEmpty());
}

void RandomEditsTest::open(unsigned seed) {
    m_random.seed(seed);
    m_document = std::make_unique<Document>();
    document::FractalFile read;
    while (read.entries.isEmpty()) {
        QFile file(m_files[any(int(m_files.size()))]);
        QVERIFY(file.open(QIODevice::ReadOnly));
        m_last = file.fileName().toUtf8();
        read = io::readFractint(file.readAll(), QStringLiteral("bare"));
    }
    while (read.entries.size() > 3)
        read.entries.removeAt(any(int(read.entries.size())));
    m_document->setFile(read);
}

void RandomEditsTest::whatIsEditedIsReadAgain() {
    const int rounds = qEnvironmentVariable("BARYCAGE_EDITS_ROUNDS", QStringLiteral("40")).toInt();
    const auto first = qEnvironmentVariable("BARYCAGE_EDITS_SEED", QStringLiteral("1")).toUInt();
    for (unsigned seed = first; seed < first + unsigned(rounds); ++seed) {
        open(seed);
        QByteArrayList done{m_last};
        for (int k = 0; k < 25; ++k) {
            m_last.clear();
            step();
            done << m_last;
            support::Complaint complaint;
            for (const document::Entry& entry : m_document->file().entries)
                if (complaint.isEmpty()) complaint = support::complaintAbout(*entry.fractal);
            if (complaint.isEmpty())
                complaint = support::complaintAbout(m_document->file(), QStringLiteral("bare"));
            if (complaint.isEmpty()) continue;
            qInfo("seed %u, after\n  %s", seed, done.join("\n  ").constData());
            QFAIL(qPrintable(complaint));
        }
    }
}

void RandomEditsTest::step() {
    static const Edit edits[] = {
        &RandomEditsTest::editMaps,    &RandomEditsTest::switchMap,       &RandomEditsTest::editWeights,
        &RandomEditsTest::moveMaps,    &RandomEditsTest::moveBranch,      &RandomEditsTest::arrange,
        &RandomEditsTest::moveCage,    &RandomEditsTest::changeCage,      &RandomEditsTest::fitCage,
        &RandomEditsTest::link,        &RandomEditsTest::makeSymmetric,   &RandomEditsTest::transform,
        &RandomEditsTest::animate,     &RandomEditsTest::editKeys,        &RandomEditsTest::changeLook,
        &RandomEditsTest::editEntries, &RandomEditsTest::travel,          &RandomEditsTest::save,
        &RandomEditsTest::steal,       &RandomEditsTest::changeDimension, &RandomEditsTest::label};
    const Edit edit = edits[any(int(std::size(edits)))];
    // An entry that could not be read offers nothing to edit.
    if (document::dimension(m_document->fractal()) != 0)
        (this->*edit)();
    else
        editEntries();
}

void RandomEditsTest::editMaps() {
    const Fractal& now = m_document->fractal();
    if (!document::system2(now)) return;
    switch (any(5)) {
    case 0:
        return put("new map", withNewMap(now).fractal);
    case 1:
        if (mapCount() < 40) put("duplicate", withDuplicates(now, anyRows()).fractal);
        return;
    case 2:
        return put("delete", withoutMaps(now, anyRows()).fractal);
    case 3:
        return put("move rows", withMapsMoved(now, anyRows(), any(mapCount() + 1)).fractal);
    default:
        return put("paste", withMapsPasted(now, anyRows(), document::system2(now)->maps).fractal);
    }
}

void RandomEditsTest::switchMap() {
    Fractal after = m_document->fractal();
    auto* system = document::system2(after);
    if (!system || system->maps.empty()) return;
    auto& map = system->maps[std::size_t(any(mapCount()))];
    map.enabled = !map.enabled;
    put("switch a map", std::move(after));
}

void RandomEditsTest::editWeights() {
    const Fractal& now = m_document->fractal();
    if (mapCount() == 0) return;
    if (any(2)) return put("weight", withWeight(now, any(mapCount()), any(5) ? anyIn(0, 2) : 0));
    put("weights", withWeights(now, static_cast<document::WeightRule>(any(4))));
}

void RandomEditsTest::moveMaps() {
    const auto fractal = m_document->sharedFractal();
    if (mapCount() == 0) return;
    const document::MapHandles handles(fractal, effectiveCage(*fractal));
    if (!handles.canBeMoved()) return;
    const auto map = std::size_t(any(mapCount()));
    if (any(2))
        return put("corner of a map", handles.withCornerMoved(map, std::size_t(any(3)), anyVector(0.4)));
    put("map", handles.withMapsMoved(std::vector{map}, anyVector(0.4)));
}

void RandomEditsTest::moveBranch() {
    const auto fractal = m_document->sharedFractal();
    std::vector<int> active;
    for (int map = 0; map < mapCount(); ++map)
        if (document::system2(*fractal)->maps[std::size_t(map)].enabled) active.push_back(map);
    if (active.empty()) return;
    ifs::Word word;
    for (int depth = 1 + any(3); depth > 0; --depth)
        word.push_back(static_cast<ifs::Word::value_type>(active[std::size_t(any(int(active.size())))]));
    const auto handles = document::MapHandles::ofBranch(fractal, effectiveCage(*fractal), word);
    if (!handles.canBeMoved()) return;
    put("branch", handles.withMapsMoved(std::vector<std::size_t>{0}, anyVector(0.3)));
}

void RandomEditsTest::arrange() {
    std::vector<std::size_t> indices;
    for (const int row : anyRows())
        indices.push_back(std::size_t(row));
    m_last = "arrange";
    arrangeMaps(*m_document, indices, static_cast<document::MapsArrangement>(any(9)));
}

void RandomEditsTest::moveCage() {
    if (!document::system2(m_document->fractal())) return;
    const auto vertices = effectiveCage(m_document->fractal()).current;
    m_last = "vertex";
    const int vertex = any(int(vertices.size()));
    moveVertex(*m_document, vertex, vertices[std::size_t(vertex)] + anyVector(any(4) ? 0.4 : 40));
}

void RandomEditsTest::changeCage() {
    if (!document::system2(m_document->fractal())) return;
    const int vertices = int(effectiveCage(m_document->fractal()).current.size());
    m_last = "cage";
    switch (any(7)) {
    case 0:
        resetCage(*m_document);
        return;
    case 1:
        bakeCage(*m_document);
        return;
    case 2:
        unbakeCage(*m_document);
        return;
    case 3:
        if (vertices < 9) insertVertex(*m_document, any(vertices), anyIn(0.1, 0.9));
        return;
    case 4:
        removeVertices(*m_document, {std::size_t(any(vertices))});
        return;
    case 5:
        makeCageRegular(*m_document);
        return;
    default:
        defineTriangle(*m_document, {anyVector(2), anyVector(2), anyVector(2)});
    }
}

void RandomEditsTest::fitCage() {
    const Fractal& now = m_document->fractal();
    if (!document::system2(now)) return;
    if (any(2)) return put("fit triangle", withCageFitted(now, static_cast<document::SimplexChoice>(any(5))));
    const auto fits = document::cageFits<2>();
    put("fit polygon", withCageAround(now, fits[std::size_t(any(int(fits.size())))].choice, 3 + any(4)));
}

void RandomEditsTest::link() {
    const Fractal& now = m_document->fractal();
    if (mapCount() == 0 || !linkObstacle(now).isEmpty()) return;
    if (any(4) == 0) return put("no links", withoutLinks(now));
    put("link", withLink(now, any(mapCount()), any(mapCount()), any(2) ? 0 : anyIn(0, 2)));
}

void RandomEditsTest::makeSymmetric() {
    const Fractal& now = m_document->fractal();
    if (!document::system2(now)) return;
    if (any(4) == 0 && expandObstacle(now).isEmpty() &&
        document::symmetryOrder(now) * std::size_t(mapCount()) < 60)
        return put("expand", expanded(now));
    ifs::Symmetry<2> symmetry;
    symmetry.group = static_cast<ifs::SymmetryGroup>(any(4));
    if (symmetry.group != ifs::SymmetryGroup::None) symmetry.centre = anyVector(1);
    if (symmetry.group >= ifs::SymmetryGroup::Rotation) symmetry.order = 2 + any(5);
    if (symmetry.group == ifs::SymmetryGroup::Mirror || symmetry.group == ifs::SymmetryGroup::Dihedral)
        symmetry.angle = any(2) ? anyIn(-180, 180) : 0;
    if (symmetryObstacle(now, std::size_t(12)).isEmpty()) put("symmetry", withSymmetry(now, symmetry));
}

void RandomEditsTest::transformInSpace() {
    const auto vector = [this](double reach) {
        return ifs::Vector<3>(anyIn(-reach, reach), anyIn(-reach, reach), anyIn(-reach, reach));
    };
    document::SpaceTransformation change;
    change.scale = any(2) ? vector(2) : ifs::Vector<3>::Constant(anyIn(0.3, 2));
    change.axis = vector(1);
    change.rotation = anyIn(-180, 180);
    change.translation = vector(3);
    const Fractal& now = m_document->fractal();
    if (any(2)) return put("place in space", placed(now, affineMap(change)));
    put("rewrite in space", rewritten(now, affineMap(change)));
}

void RandomEditsTest::transform() {
    document::Transformation change;
    change.reflect = any(3) == 0;
    change.axis = anyIn(-3, 3);
    change.shear = any(2) ? anyIn(-0.5, 0.5) : 0;
    change.scaleX = anyIn(0.3, 2);
    change.scaleY = anyIn(-2, 2);
    change.rotation = anyIn(-3, 3);
    change.translation = anyVector(3);
    const Fractal& now = m_document->fractal();
    if (document::system3(now)) return transformInSpace();
    if (any(2)) return put("place", placed(now, affineMap(change)));
    put("rewrite", rewritten(now, affineMap(change)));
}

void RandomEditsTest::changeDimension() {
    const Fractal& entry = m_document->entryFractal();
    m_last = "dimension";
    const bool lifts = document::system2(entry) != nullptr;
    const QString obstacle = lifts ? liftObstacle(entry) : flattenObstacle(entry, {0, 0, 1});
    if (!obstacle.isEmpty()) return;
    if (const auto after = lifts ? document::lifted(entry) : flattened(entry, {0, 0, 1}))
        m_document->editEntry(QStringLiteral("dimension"), *after);
}

void RandomEditsTest::animate() {
    const Fractal& entry = m_document->entryFractal();
    std::optional<Fractal> after;
    switch (any(4)) {
    case 0:
        after = withTurn(entry);
        break;
    case 1:
        after = withBreathing(entry);
        break;
    case 2:
        after = withPaletteCycle(entry);
        break;
    default:
        after = document::withWind(entry, animation::swayPresets().front());
    }
    m_last = "motion";
    if (after) m_document->editEntry(QStringLiteral("motion"), *after);
}

void RandomEditsTest::editKeys() {
    Fractal entry = m_document->entryFractal();
    m_last = "keys";
    const auto tracks = tracksOf(entry);
    if (tracks.empty() || any(2)) {
        document::Track track;
        track.kind = any(2) ? document::Track::Kind::Cage : document::Track::Kind::Look;
        if (mapCount() > 0 && any(3) == 0)
            track = {document::Track::Kind::Map,
                     {document::system2(m_document->fractal())->maps[std::size_t(any(mapCount()))].id}};
        m_document->setMoment(animation::moment(any(40)));
        return m_document->editEntry(QStringLiteral("key"), withKey(entry, track, any(40), std::nullopt));
    }
    const auto& track = tracks[std::size_t(any(int(tracks.size())))];
    if (track.keys.empty()) return;
    const document::KeyAt at{track.track, track.keys[std::size_t(any(int(track.keys.size())))].frame};
    m_document->editEntry(QStringLiteral("no key"), withoutKeys(entry, std::span(&at, 1)));
}

void RandomEditsTest::changeLook() {
    Fractal after = m_document->fractal();
    attractor::Appearance& look = after.appearance;
    look.colourBy = static_cast<attractor::ColourBy>(any(4));
    const auto& palettes = attractor::builtInPalettes();
    look.palette = palettes[std::size_t(any(int(palettes.size())))];
    look.gamma = anyIn(0.2, 5);
    look.brightness = anyIn(0.1, 300);
    look.contrast = any(3) ? 1 : anyIn(0.2, 5);
    look.vibrancy = any(3) ? 1 : anyIn(0, 1);
    look.shadow = any(3) ? 0 : anyIn(0, 1);
    look.shadowLean = anyIn(-3, 3);
    look.shadowLength = anyIn(-3, 3);
    look.plain = {std::uint8_t(any(256)), std::uint8_t(any(256)), 7, 255};
    look.background.alpha = any(2) ? 255 : 0;
    if (mapCount() > 0)
        look.mapColours[document::system2(after)->maps[std::size_t(any(mapCount()))].id] = {
            std::uint8_t(any(256)), 1, 2, 255};
    put("look", std::move(after));
}

void RandomEditsTest::label() {
    if (mapCount() == 0) return;
    const auto& maps = document::system2(m_document->fractal())->maps;
    const auto index = std::size_t(any(mapCount()));
    m_last = "label";
    if (any(2)) {
        const std::array ids{maps[index].id};
        return document::lockMaps(*m_document, ids, any(3) != 0);
    }
    static const char* const names[] = {"", "stem", "left } leaf {", "100 %", "лист 🌿", "a  b\nc \\"};
    const QString name = QString::fromUtf8(names[any(int(std::size(names)))]);
    document::renameMap(*m_document, index, name.repeated(1 + any(12)));
}

void RandomEditsTest::editEntries() {
    const document::FractalFile& file = m_document->file();
    const document::Entry& one = file.entries[any(int(file.entries.size()))];
    m_last = "entries";
    switch (any(5)) {
    case 0:
        if (file.entries.size() < 6)
            m_document->editFile(QStringLiteral("insert"), inserted(file, {one}, one.id).file);
        return;
    case 1:
        if (file.entries.size() > 1) m_document->editFile(QStringLiteral("remove"), removed(file, {one.id}));
        return;
    case 2:
        return m_document->editFile(QStringLiteral("move"), moved(file, {one.id}, file.entries.front().id));
    case 3: {
        Fractal renamed = *one.fractal;
        renamed.name = QStringLiteral("name%1").arg(any(1000));
        if (nameProblem(file, one.id, renamed.name)) return;
        return m_document->editFile(QStringLiteral("rename"), replaced(file, one.id, renamed));
    }
    default:
        m_document->setCurrent(one.id);
    }
}

void RandomEditsTest::steal() {
    const document::FractalFile& file = m_document->file();
    document::KeptTheft theft;
    theft.partner = file.entries[any(int(file.entries.size()))].fractal->name;
    if (any(2))
        for (int map = mapCount(); map-- > 0;)
            theft.order.push_back(std::size_t(map));
    theft.mode = static_cast<document::TheftMode>(any(5));
    if (any(2)) theft.picture = QStringLiteral("pictures/a b.png");
    if (any(2)) theft.view = attractor::View{anyVector(2), anyIn(0.1, 4)};
    const bool gone = any(4) == 0;
    put("theft", withTheft(m_document->fractal(), gone ? std::nullopt : std::optional(theft)));
}

void RandomEditsTest::travel() {
    QUndoStack& history = *m_document->undoStack();
    m_last = "history";
    history.setIndex(std::max(0, history.index() - any(4)));
    history.setIndex(std::min(history.count(), history.index() + any(3)));
}

// As the window does: what was written becomes what an entry was read from.
void RandomEditsTest::save() {
    m_last = "save";
    const QByteArray bytes = io::writeFractint(m_document->file());
    m_document->setFile(io::readFractint(bytes, QStringLiteral("bare")));
}

BARYCAGE_TEST(RandomEditsTest, QGuiApplication);
#include "random_edits_test.moc"
