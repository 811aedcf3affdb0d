// SPDX-License-Identifier: MIT
#include "attractor/colour/srgb_transfer.h"
#include "io/collection_reader.h"
#include "io/picture/picture_writers.h"
#include "io/raster/raster_system.h"
#include "support/named_test.h"

#include <QBuffer>
#include <QFile>
#include <QImage>
#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QTest>

#include <new>

#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStandardAttributes.h>
#include <tiffio.h>
#include <webp/decode.h>

using namespace io;
using attractor::Rgba16;

namespace {

const QByteArray fern = "fern { ; Barnsley’s <fern> & more\n 0 0 0 .16 0 0 .01\n}\n";
constexpr int width = 61, height = 37; // neither is a whole number of strips or blocks

PictureFormat format(PictureFormat::Pixels pixels, PictureFormat::Depth depth) {
    PictureFormat format;
    format.width = width;
    format.height = height;
    format.pixels = pixels;
    format.depth = depth;
    format.systemText = fern;
    return format;
}

// As in the program: into a file that appears whole.
template <class Pixel>
QByteArray written(PictureFile file, const PictureFormat& format, const std::vector<Pixel>& pixels) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("picture"));
    {
        NewFile device(path);
        const auto writer = pictureWriter(file, device, format);
        const std::span<const Pixel> rows(pixels);
        const std::size_t first = 10 * width;
        if (writer->writeRows(rows.first(first)) || writer->writeRows(rows.subspan(first)) ||
            writer->finish() || device.commit())
            return {};
    }
    QFile saved(path);
    return saved.open(QIODevice::ReadOnly) ? saved.readAll() : QByteArray();
}

std::vector<std::uint32_t> randomBytes(bool isOpaque) {
    QRandomGenerator random(7);
    std::vector<std::uint32_t> pixels(width * height);
    for (auto& pixel : pixels)
        pixel = qPremultiply(random.generate() | (isOpaque ? 0xff000000U : 0U));
    return pixels;
}

std::vector<Rgba16> randomWords(bool isOpaque) {
    QRandomGenerator random(8);
    const auto word = [&] { return std::uint16_t(random.bounded(65536)); };
    std::vector<Rgba16> pixels(width * height);
    for (auto& pixel : pixels)
        pixel = {word(), word(), word(), isOpaque ? std::uint16_t(65535) : word()};
    return pixels;
}

struct Tiff {
    std::uint16_t samples = 0, bits = 0;
    float dotsPerInch = 0;
    std::vector<std::uint8_t> bytes;
};

Tiff readTiff(const QByteArray& file) {
    const QTemporaryDir folder;
    const QByteArray path = QFile::encodeName(folder.filePath(QStringLiteral("a.tiff")));
    QFile copy(QFile::decodeName(path));
    if (!copy.open(QIODevice::WriteOnly)) return {};
    copy.write(file);
    copy.close();
    TIFF* tiff = TIFFOpen(path.constData(), "r");
    if (!tiff) return {};
    Tiff result;
    TIFFGetField(tiff, TIFFTAG_SAMPLESPERPIXEL, &result.samples);
    TIFFGetField(tiff, TIFFTAG_BITSPERSAMPLE, &result.bits);
    TIFFGetField(tiff, TIFFTAG_XRESOLUTION, &result.dotsPerInch);
    const auto row = std::size_t(TIFFScanlineSize(tiff));
    result.bytes.resize(row * height);
    for (int y = 0; y < height; ++y)
        TIFFReadScanline(tiff, result.bytes.data() + row * std::size_t(y), std::uint32_t(y), 0);
    TIFFClose(tiff);
    return result;
}

// Red, green, blue, alpha of each pixel.
std::vector<float> readExr(const QByteArray& file, float& density) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.exr"));
    QFile copy(path);
    if (!copy.open(QIODevice::WriteOnly)) return {};
    copy.write(file);
    copy.close();
    Imf::InputFile exr(QFile::encodeName(path).constData(), 1);
    if (Imf::hasXDensity(exr.header())) density = Imf::xDensity(exr.header());
    std::vector<float> numbers(4 * width * height, -1.0F);
    Imf::FrameBuffer frame;
    const char* names[]{"R", "G", "B", "A"};
    for (std::size_t i = 0; i < 4; ++i)
        frame.insert(names[i], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(numbers.data() + i),
                                          4 * sizeof(float), 4 * sizeof(float) * width, 1, 1, 1.0));
    exr.setFrameBuffer(frame);
    exr.readPixels(0, height - 1);
    return numbers;
}

// A disk that is full after `room` bytes.
class FullDisk : public QIODevice {
public:
    explicit FullDisk(qint64 room) : m_room(room) {
        open(QIODevice::WriteOnly | QIODevice::Unbuffered);
        setErrorString(QStringLiteral("No space left on device"));
    }

protected:
    qint64 readData(char*, qint64) override { return -1; }
    qint64 writeData(const char*, qint64 size) override {
        m_room -= size;
        return m_room < 0 ? -1 : size;
    }

private:
    qint64 m_room;
};

const std::vector<std::pair<PictureFile, const char*>> kinds{{PictureFile::Jpeg, "jpeg"},
                                                             {PictureFile::WebP, "webp"},
                                                             {PictureFile::Tiff, "tiff"},
                                                             {PictureFile::ExrHalf, "exr"},
                                                             {PictureFile::ExrFloat, "exr"}};

PictureFormat::Depth depthFor(PictureFile file) {
    using enum PictureFormat::Depth;
    return takes(file, Bits8) ? Bits8 : Bits16;
}

QByteArray writtenTo(PictureFile file, const PictureFormat& format) {
    return format.depth == PictureFormat::Depth::Bits8 ? written(file, format, randomBytes(true))
                                                       : written(file, format, randomWords(true));
}

// A device whose call of one number, among writes and seeks, fails: all others succeed.
class FailingOnce : public QIODevice {
public:
    enum class Way { Refuses, Throws };

    FailingOnce(int call, Way way) : m_call(call), m_way(way) {
        open(QIODevice::WriteOnly | QIODevice::Unbuffered);
    }

    bool seek(qint64 position) override { return !fails() && QIODevice::seek(position); }
    bool hasFailed() const { return m_calls >= m_call; }

protected:
    qint64 readData(char*, qint64) override { return -1; }
    qint64 writeData(const char*, qint64 size) override { return fails() ? -1 : size; }

private:
    bool fails() {
        if (++m_calls != m_call) return false;
        if (m_way == Way::Throws) throw std::bad_alloc();
        return true;
    }

    int m_call;
    Way m_way;
    int m_calls = 0;
};

Failure writeAll(PictureWriter& writer, const PictureFormat& form) {
    return form.depth == PictureFormat::Depth::Bits8
               ? writer.writeRows(std::span<const std::uint32_t>(randomBytes(true)))
               : writer.writeRows(std::span<const Rgba16>(randomWords(true)));
}

} // namespace

class RasterWritersTest : public QObject {
    Q_OBJECT

private slots:
    void jpegIsCloseToThePicture();
    void webpComesBack_data();
    void webpComesBack();
    void tiffComesBack_data();
    void tiffComesBack();
    void exrHoldsLinearLight_data();
    void exrHoldsLinearLight();
    void systemComesBack();
    void longSystemsComeBack();
    void picturesOfOthersCarryNoSystem();
    void shortenedPicturesAreRefusedOrWhole();
    void impossiblePicturesAreRefusedBefore();
    void fullDisksAreSaid();
    void everyRefusalIsSaid_data() { everyKind(); }
    void everyRefusalIsSaid();
    void nothingIsThrownThroughLibraries_data() { everyKind(); }
    void nothingIsThrownThroughLibraries();

private:
    static void everyKind();
};

void RasterWritersTest::jpegIsCloseToThePicture() {
    PictureFormat smooth = format(PictureFormat::Pixels::Opaque, PictureFormat::Depth::Bits8);
    smooth.dotsPerInch = 300;
    std::vector<std::uint32_t> pixels;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            pixels.push_back(qRgb(4 * x, 6 * y, 255 - 2 * (x + y)));
    const auto worst = [&](const QByteArray& bytes) {
        const QImage image = QImage::fromData(bytes, "JPEG");
        int error = image.size() == QSize(width, height) ? 0 : 1000;
        for (int i = 0; error < 1000 && i < width * height; ++i) {
            const QRgb a = image.pixel(i % width, i / width), b = pixels[std::size_t(i)];
            error = std::max({error, std::abs(qRed(a) - qRed(b)), std::abs(qGreen(a) - qGreen(b)),
                              std::abs(qBlue(a) - qBlue(b))});
        }
        return error;
    };
    const QByteArray usual = written(PictureFile::Jpeg, smooth, pixels);
    QVERIFY2(worst(usual) <= 16, qPrintable(QString::number(worst(usual))));
    QCOMPARE(QImage::fromData(usual, "JPEG").dotsPerMeterX(), 11811);
    smooth.quality = 20;
    const QByteArray poor = written(PictureFile::Jpeg, smooth, pixels);
    QVERIFY(!poor.isEmpty() && poor.size() < usual.size() && worst(poor) > worst(usual));
}

void RasterWritersTest::webpComesBack_data() {
    QTest::addColumn<bool>("isOpaque");
    QTest::newRow("opaque") << true;
    QTest::newRow("transparent") << false;
}

void RasterWritersTest::webpComesBack() {
    QFETCH(bool, isOpaque);
    PictureFormat form = format(isOpaque ? PictureFormat::Pixels::Opaque : PictureFormat::Pixels::Transparent,
                                PictureFormat::Depth::Bits8);
    const auto pixels = randomBytes(isOpaque);
    const QByteArray bytes = written(PictureFile::WebP, form, pixels);
    int across = 0, down = 0;
    std::uint8_t* decoded = WebPDecodeRGBA(reinterpret_cast<const std::uint8_t*>(bytes.constData()),
                                           std::size_t(bytes.size()), &across, &down);
    QVERIFY(decoded && across == width && down == height);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const QRgb expected = qUnpremultiply(pixels[i]);
        const std::uint8_t* at = decoded + 4 * i;
        if (qAlpha(expected) != 0) QCOMPARE(qRgba(at[0], at[1], at[2], at[3]), expected);
    }
    WebPFree(decoded);
    form.quality = 50;
    const QByteArray lossy = written(PictureFile::WebP, form, pixels);
    QVERIFY(!lossy.isEmpty() && lossy.size() < bytes.size());
}

void RasterWritersTest::tiffComesBack_data() {
    QTest::addColumn<bool>("isOpaque");
    QTest::addColumn<bool>("isDeep");
    QTest::newRow("opaque") << true << false;
    QTest::newRow("transparent") << false << false;
    QTest::newRow("opaque, 16 bits") << true << true;
    QTest::newRow("transparent, 16 bits") << false << true;
}

void RasterWritersTest::tiffComesBack() {
    QFETCH(bool, isOpaque);
    QFETCH(bool, isDeep);
    PictureFormat form = format(isOpaque ? PictureFormat::Pixels::Opaque : PictureFormat::Pixels::Transparent,
                                isDeep ? PictureFormat::Depth::Bits16 : PictureFormat::Depth::Bits8);
    form.dotsPerInch = 300;
    const std::size_t channels = isOpaque ? 3 : 4;
    std::vector<std::uint8_t> expected;
    QByteArray bytes;
    if (isDeep) {
        const auto pixels = randomWords(isOpaque);
        bytes = written(PictureFile::Tiff, form, pixels);
        for (const Rgba16& pixel : pixels) {
            const std::uint16_t values[]{pixel.red, pixel.green, pixel.blue, pixel.alpha};
            const auto* raw = reinterpret_cast<const std::uint8_t*>(values);
            expected.insert(expected.end(), raw, raw + 2 * channels);
        }
    } else {
        const auto pixels = randomBytes(isOpaque);
        bytes = written(PictureFile::Tiff, form, pixels);
        for (const std::uint32_t pixel : pixels) {
            const QRgb colour = qUnpremultiply(pixel);
            const std::uint8_t values[]{std::uint8_t(qRed(colour)), std::uint8_t(qGreen(colour)),
                                        std::uint8_t(qBlue(colour)), std::uint8_t(qAlpha(colour))};
            expected.insert(expected.end(), values, values + channels);
        }
    }
    const Tiff tiff = readTiff(bytes);
    QCOMPARE(std::size_t(tiff.samples), channels);
    QCOMPARE(int(tiff.bits), isDeep ? 16 : 8);
    QCOMPARE(tiff.dotsPerInch, 300.0F);
    QVERIFY(tiff.bytes == expected);
}

void RasterWritersTest::exrHoldsLinearLight_data() {
    QTest::addColumn<bool>("isOpaque");
    QTest::addColumn<bool>("isFloat");
    QTest::newRow("opaque, half") << true << false;
    QTest::newRow("transparent, half") << false << false;
    QTest::newRow("opaque, float") << true << true;
    QTest::newRow("transparent, float") << false << true;
}

void RasterWritersTest::exrHoldsLinearLight() {
    QFETCH(bool, isOpaque);
    QFETCH(bool, isFloat);
    PictureFormat form = format(isOpaque ? PictureFormat::Pixels::Opaque : PictureFormat::Pixels::Transparent,
                                PictureFormat::Depth::Bits16);
    form.dotsPerInch = 300;
    const auto pixels = randomWords(isOpaque);
    float density = 0;
    const auto numbers =
        readExr(written(isFloat ? PictureFile::ExrFloat : PictureFile::ExrHalf, form, pixels), density);
    QCOMPARE(density, 300.0F);
    QCOMPARE(numbers.size(), 4 * pixels.size());
    const double tolerance = isFloat ? 1e-6 : 1.0 / 2048; // of the number, or of 1/16384 near 0
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const double alpha = pixels[i].alpha / 65535.0;
        const std::uint16_t codes[]{pixels[i].red, pixels[i].green, pixels[i].blue};
        for (std::size_t k = 0; k < 3; ++k) {
            const double light = alpha * attractor::linearFromEncoded(codes[k] / 65535.0);
            QVERIFY(std::abs(numbers[4 * i + k] - light) <= tolerance * std::max(light, 1.0 / 16384));
        }
        QVERIFY(std::abs(numbers[4 * i + 3] - alpha) <= tolerance * std::max(alpha, 1.0 / 16384));
    }
}

void RasterWritersTest::systemComesBack() {
    for (const auto& [file, name] : kinds) {
        const QByteArray bytes = writtenTo(file, format(PictureFormat::Pixels::Opaque, depthFor(file)));
        QVERIFY2(!bytes.isEmpty(), name);
        QCOMPARE(rasterFormat(bytes), QLatin1String(name));
        const EmbeddedSystem system = readRasterSystem(bytes);
        QVERIFY2(!system.failure, name);
        QCOMPARE(system.text, fern);
        const Collection collection = readCollection(bytes);
        QCOMPARE(collection.format, QLatin1String(name));
        QCOMPARE(collection.file.entries.first().fractal->name, QStringLiteral("fern"));
        QCOMPARE(writtenTo(file, format(PictureFormat::Pixels::Opaque, depthFor(file))), bytes);
    }
}

// A comment of a JPEG has at most 64 KB.
void RasterWritersTest::longSystemsComeBack() {
    for (const auto& [file, name] : kinds) {
        PictureFormat form = format(PictureFormat::Pixels::Opaque, depthFor(file));
        form.systemText = fern.repeated(5000);
        const EmbeddedSystem system = readRasterSystem(writtenTo(file, form));
        QVERIFY2(!system.failure && system.text == form.systemText, name);
    }
}

void RasterWritersTest::picturesOfOthersCarryNoSystem() {
    for (const auto& [file, name] : kinds) {
        PictureFormat form = format(PictureFormat::Pixels::Opaque, depthFor(file));
        form.systemText.clear();
        const EmbeddedSystem system = readRasterSystem(writtenTo(file, form));
        QVERIFY2(system.text.isEmpty() && system.failure->contains(QStringLiteral("no system")), name);
    }
}

// At whatever byte they end, and whatever byte is changed in what stands before the pixels.
void RasterWritersTest::shortenedPicturesAreRefusedOrWhole() {
    for (const auto& [file, name] : kinds) {
        const QByteArray bytes = writtenTo(file, format(PictureFormat::Pixels::Opaque, depthFor(file)));
        for (qsizetype size = 12; size < bytes.size(); size += size < 2000 ? 1 : 97) {
            const EmbeddedSystem system = readRasterSystem(bytes.first(size));
            QVERIFY2(system.failure ? system.text.isEmpty() : system.text == fern, name);
        }
        QRandomGenerator random(9);
        for (int i = 0; i < 2000; ++i) {
            QByteArray damaged = bytes;
            for (int k = 0; k < 3; ++k)
                damaged[random.bounded(12, int(damaged.size()))] = char(random.bounded(256));
            const EmbeddedSystem system = readRasterSystem(damaged);
            QVERIFY2(bool(system.failure) == system.text.isEmpty(), name);
        }
    }
}

void RasterWritersTest::impossiblePicturesAreRefusedBefore() {
    using enum PictureFormat::Pixels;
    using enum PictureFormat::Depth;
    QVERIFY(!whyImpossible(PictureFile::Jpeg, format(Opaque, Bits8)));
    QVERIFY(whyImpossible(PictureFile::Jpeg, format(Transparent, Bits8))->contains(u"transparent"));
    QVERIFY(whyImpossible(PictureFile::Jpeg, format(Opaque, Bits16)));
    QVERIFY(whyImpossible(PictureFile::ExrHalf, format(Opaque, Bits8)));
    QVERIFY(whyImpossible(PictureFile::Tiff, format(Grey, Bits16)));
    QVERIFY(!whyImpossible(PictureFile::Png, format(Grey, Bits16)));
    PictureFormat large = format(Opaque, Bits8);
    large.height = 16'384;
    QVERIFY(whyImpossible(PictureFile::WebP, large)->contains(u"16383"));
    QVERIFY(!whyImpossible(PictureFile::Jpeg, large));
    large.height = 65'501;
    QVERIFY(whyImpossible(PictureFile::Jpeg, large)->contains(u"65500"));
    QVERIFY(!whyImpossible(PictureFile::Tiff, large));
}

void RasterWritersTest::fullDisksAreSaid() {
    for (const auto& [file, name] : kinds) {
        const PictureFormat form = format(PictureFormat::Pixels::Opaque, depthFor(file));
        const qint64 whole = writtenTo(file, form).size();
        for (const qint64 room : {qint64(0), qint64(100), whole / 2, whole - 1}) {
            FullDisk disk(room);
            Failure failure;
            {
                const auto writer = pictureWriter(file, disk, form);
                failure = writeAll(*writer, form);
                failure = writer->finish();
            }
            QVERIFY2(failure && failure->contains(QStringLiteral("No space left")), name);
        }
    }
}

void RasterWritersTest::everyKind() {
    QTest::addColumn<PictureFile>("file");
    for (const auto& [file, name] : kinds)
        QTest::addRow("%s %d", name, int(file)) << file;
    QTest::newRow("png") << PictureFile::Png;
}

// Also where the library that writes the file does not pass it on.
void RasterWritersTest::everyRefusalIsSaid() {
    QFETCH(PictureFile, file);
    const PictureFormat form = format(PictureFormat::Pixels::Opaque, depthFor(file));
    for (int call = 1;; ++call) {
        FailingOnce device(call, FailingOnce::Way::Refuses);
        const auto writer = pictureWriter(file, device, form);
        const Failure rows = writeAll(*writer, form);
        const Failure failure = writer->finish();
        QVERIFY2(!rows || failure, "it is forgotten");
        QVERIFY2(failure.has_value() == device.hasFailed(), qPrintable(QString::number(call)));
        if (!failure) {
            QVERIFY(call > 1);
            break;
        }
    }
}

// What a device throws comes out of the function that was called, once, and nothing is written after it.
void RasterWritersTest::nothingIsThrownThroughLibraries() {
    QFETCH(PictureFile, file);
    const PictureFormat form = format(PictureFormat::Pixels::Opaque, depthFor(file));
    for (int call = 1;; ++call) {
        FailingOnce device(call, FailingOnce::Way::Throws);
        std::unique_ptr<PictureWriter> writer;
        int thrown = 0;
        const auto orThrown = [&thrown](const auto& action) {
            try {
                action();
            } catch (const std::bad_alloc&) {
                ++thrown;
            }
        };
        orThrown([&] { writer = pictureWriter(file, device, form); });
        Failure failure;
        if (writer) {
            orThrown([&] { failure = writeAll(*writer, form); });
            orThrown([&] { failure = writer->finish(); });
            QVERIFY(thrown == 0 || writer->finish()); // it is remembered
        }
        QVERIFY2(thrown == (device.hasFailed() ? 1 : 0), qPrintable(QString::number(call)));
        if (!device.hasFailed()) {
            QVERIFY(!failure && call > 1);
            break;
        }
    }
}

BARYCAGE_TEST(RasterWritersTest, QCoreApplication);
#include "raster_writers_test.moc"
