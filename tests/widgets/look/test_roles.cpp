// SPDX-License-Identifier: GPL-3.0-or-later
// Contrast, measured on painted pixels, in light and dark.
#include "tests/support/contrast.h"
#include "widgets/look/appearance.h"
#include "widgets/look/palettes.h"
#include "widgets/look/role_label.h"
#include "widgets/monitor/word_view.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QImage>
#include <QLineEdit>
#include <QPalette>
#include <QPushButton>
#include <QRect>
#include <QRegion>
#include <QRgb>
#include <QSpinBox>
#include <QStyle>
#include <QWidget>

#include <gtest/gtest.h>
#include <vector>

namespace codewheel {
namespace {

using test::contrast;

// The pixel that stands out most from the background: the inside of a stroke, not its soft edge.
double strongestContrast(const QImage &image, QRgb ground)
{
    double strongest = 1;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            strongest = std::max(strongest, contrast(image.pixel(x, y), ground));
    return strongest;
}

class Contrast : public testing::TestWithParam<Scheme>
{
protected:
    Contrast()
    {
        applyAppearance(*qApp, {.scheme = GetParam()});
        windowGround = qApp->palette().window().color().rgb();
    }
    ~Contrast() override { applyAppearance(*qApp, {.scheme = Scheme::light}); }

    // At twice the size, so that strokes have an inside.
    QImage grab(QWidget &widget, QRect rect)
    {
        QImage image(rect.size() * 2, QImage::Format_RGB32);
        image.setDevicePixelRatio(2);
        widget.render(&image, {}, QRegion(rect));
        return image;
    }

    QRgb windowGround = 0;
};

TEST_P(Contrast, IconsOfRolesStandOutThreeToOneAndTheirWordsFourAndAHalf)
{
    for (const Role role : allRoles) {
        RoleLabel label;
        label.setState(role);
        label.resize(label.sizeHint());
        const int words = label.width() - 20;
        EXPECT_GE(strongestContrast(grab(label, QRect(0, 0, 16, label.height())), windowGround), 3.0)
            << label.word().toStdString();
        EXPECT_GE(strongestContrast(grab(label, QRect(20, 0, words, label.height())), windowGround), 4.5)
            << label.word().toStdString();
    }
}

TEST_P(Contrast, ASetBitStandsOutAndItsDigitFromIt)
{
    WordView view(wordForm(16, nullptr),
                  {{.caption = QStringLiteral("IN"), .place = QStringLiteral("IN 1.0")}});
    view.setWord(0, 1, 1, 0, {});
    const QImage cell = grab(view, view.bitRect({0, 0}));
    const QRgb fill = cell.pixel(cell.width() / 2, 8);
    EXPECT_EQ(fill, roleColor(Role::setBit, qApp->palette()).rgb());
    EXPECT_GE(contrast(fill, windowGround), 3.0);
    EXPECT_GE(strongestContrast(cell.copy(cell.rect().adjusted(10, 12, -10, -12)), fill), 4.5);
}

TEST_P(Contrast, AClearBitHasARimAndADigitToSee)
{
    WordView view(wordForm(16, nullptr),
                  {{.caption = QStringLiteral("IN"), .place = QStringLiteral("IN 1.0")}});
    const QImage cell = grab(view, view.bitRect({0, 0}));
    const QRgb inside = cell.pixel(cell.width() / 2, 8);
    EXPECT_EQ(inside, qApp->palette().base().color().rgb());
    EXPECT_GE(strongestContrast(cell.copy(0, cell.height() / 2, 6, 1), windowGround), 3.0);
    EXPECT_GE(strongestContrast(cell.copy(cell.rect().adjusted(10, 12, -10, -12)), inside), 4.5);
}

TEST_P(Contrast, DigitsCanBeReadOnAFillOfAnyRole)
{
    for (const Role role : allRoles)
        EXPECT_GE(contrast(roleColor(role, qApp->palette()).rgb(), textOn(role, qApp->palette()).rgb()), 4.5)
            << roleWord(role).toStdString();
}

TEST_P(Contrast, FieldsAndBoxesHaveRimsToSee)
{
    QLineEdit field;
    field.resize(80, field.sizeHint().height());
    EXPECT_GE(strongestContrast(grab(field, QRect(0, field.height() / 2, 3, 1)), windowGround), 3.0);
    QSpinBox number;
    number.resize(80, number.sizeHint().height());
    EXPECT_GE(strongestContrast(grab(number, QRect(0, number.height() / 2, 3, 1)), windowGround), 3.0);
    QCheckBox box;
    box.resize(box.sizeHint());
    EXPECT_GE(strongestContrast(grab(box, QRect(0, box.height() / 2, 6, 1)), windowGround), 3.0);
}

TEST_P(Contrast, TextCanBeReadOnEveryGround)
{
    const QPalette palette = qApp->palette();
    for (const auto ground : {QPalette::Window, QPalette::Base, QPalette::AlternateBase, QPalette::Button})
        for (const auto text : {QPalette::WindowText, QPalette::Link, QPalette::PlaceholderText})
            EXPECT_GE(contrast(palette.color(text).rgb(), palette.color(ground).rgb()), 4.5)
                << "text role " << text << " on ground " << ground;
    EXPECT_GE(contrast(palette.highlightedText().color().rgb(), palette.highlight().color().rgb()), 4.5);
    EXPECT_GE(contrast(palette.toolTipText().color().rgb(), palette.toolTipBase().color().rgb()), 4.5);
}

INSTANTIATE_TEST_SUITE_P(Schemes, Contrast, testing::Values(Scheme::light, Scheme::dark),
                         [](const auto &scheme) { return scheme.param == Scheme::light ? "light" : "dark"; });

// How eyes without red cones (protanopia) and without green cones (deuteranopia) see a colour: Viénot,
// Brettel, Mollon 1999, on linear light.
std::array<double, 3> seenWithout(char cone, QRgb color)
{
    const auto linear = [](int channel) { return std::pow(channel / 255.0, 2.2); };
    const double r = linear(qRed(color));
    const double g = linear(qGreen(color));
    const double b = linear(qBlue(color));
    const double yellow = cone == 'L' ? 0.11238 * r + 0.88762 * g : 0.29275 * r + 0.70725 * g;
    const double blue = cone == 'L' ? 0.00401 * r - 0.00401 * g + b : -0.02234 * r + 0.02234 * g + b;
    return {std::pow(yellow, 1 / 2.2), std::pow(yellow, 1 / 2.2),
            std::pow(std::clamp(blue, 0.0, 1.0), 1 / 2.2)};
}

TEST_P(Contrast, ColourBlindEyesTellTheRolesApart)
{
    for (const char missingCone : {'L', 'M'})
        for (const Role a : allRoles)
            for (const Role b : allRoles) {
                if (a >= b)
                    continue;
                const auto seenA = seenWithout(missingCone, roleColor(a, qApp->palette()).rgb());
                const auto seenB = seenWithout(missingCone, roleColor(b, qApp->palette()).rgb());
                const double distance =
                    std::hypot(seenA[0] - seenB[0], seenA[1] - seenB[1], seenA[2] - seenB[2]);
                EXPECT_GE(distance, 0.1) << roleWord(a).toStdString() << " and " << roleWord(b).toStdString();
            }
}

TEST(Appearance, SystemFollowsTheLightnessOfTheDesktop)
{
    EXPECT_EQ(shadeFor(Scheme::system, paletteOf(Shade::light)), Shade::light);
    EXPECT_EQ(shadeFor(Scheme::system, paletteOf(Shade::dark)), Shade::dark);
    EXPECT_EQ(shadeFor(Scheme::light, paletteOf(Shade::dark)), Shade::light);
    EXPECT_EQ(shadeFor(Scheme::dark, paletteOf(Shade::light)), Shade::dark);
}

TEST(Appearance, ADarkSchemeDoesNotStickToSystem)
{
    applyAppearance(*qApp, {.scheme = Scheme::system});
    const Shade desktop = shadeOf(qApp->palette());
    applyAppearance(*qApp, {.scheme = desktop == Shade::light ? Scheme::dark : Scheme::light});
    EXPECT_NE(shadeOf(qApp->palette()), desktop);
    applyAppearance(*qApp, {.scheme = Scheme::system});
    EXPECT_EQ(shadeOf(qApp->palette()), desktop);
    applyAppearance(*qApp, {.scheme = Scheme::light});
}

TEST(Appearance, LargeControlsAreOneAndAHalfTimesAsHigh)
{
    QPushButton button(QStringLiteral("Write"));
    QLineEdit field;
    QSpinBox number;
    QComboBox choice;
    const std::array controls{static_cast<QWidget *>(&button), static_cast<QWidget *>(&field),
                              static_cast<QWidget *>(&number), static_cast<QWidget *>(&choice)};
    std::vector<int> usual;
    usual.reserve(controls.size());
    for (QWidget *control : controls)
        usual.push_back(control->sizeHint().height());
    applyAppearance(*qApp, {.scheme = Scheme::light, .largeControls = true});
    for (std::size_t i = 0; i < controls.size(); ++i)
        EXPECT_NEAR(controls[i]->sizeHint().height(), usual[i] * 1.5, 3)
            << controls[i]->metaObject()->className();
    applyAppearance(*qApp, {.scheme = Scheme::light});
    EXPECT_EQ(button.sizeHint().height(), usual[0]);
}

TEST(Appearance, MotionIsShortAndCanBeTurnedOff)
{
    const auto duration = [] { return qApp->style()->styleHint(QStyle::SH_Widget_Animation_Duration); };
    EXPECT_LE(duration(), 200);
    applyAppearance(*qApp, {.scheme = Scheme::light, .lessMotion = true});
    EXPECT_EQ(duration(), 0);
    applyAppearance(*qApp, {.scheme = Scheme::light});
}

} // namespace
} // namespace codewheel
