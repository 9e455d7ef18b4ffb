// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/screenshots/pictures.h"
#include "app/screenshots/scene.h"
#include "app/window/connect/trouble_of.h"
#include "doctor/hindrance_of_refusal.h"
#include "widgets/find/find_page.h"

#include <QAction>
#include <QCoreApplication>

namespace codewheel {
namespace {

using namespace scene;

const QString port = QStringLiteral("/dev/ttyUSB0");

FinderNews encoder(const QString &text)
{
    return {FinderNews::Kind::found, port, text,
            Found{.place = port, .settings = QStringLiteral("9600 Bd, 8N2"), .sentence = text}};
}

QWidget *findingIn(TrainingWindow &shown)
{
    shown.window().actions().findEncoders->trigger();
    auto *page = shown.window().findChild<FindPage *>();
    page->setPorts({{port, QStringLiteral("FT232R USB UART"), {}},
                    {QStringLiteral("/dev/ttyUSB1"), QStringLiteral("USB Serial"), {}}},
                   {});
    page->begin();
    page->add({FinderNews::Kind::heard, QStringLiteral("/dev/ttyUSB1"),
               QCoreApplication::translate("codewheel::Finder", "Bytes come, but none that make sense at %1.")
                   .arg(QStringLiteral("19200 Bd, 8N2"))});
    page->add(encoder(QStringLiteral("5882 RS485 V1.2, 03h (3), 0012D503")));
    page->add(encoder(QStringLiteral("5882 RS485 V1.2, 05h (5), 0012D505")));
    page->end();
    shown.advance(whileMilliseconds);
    return page;
}

// Of a computer of which nothing more is known, so that the picture is the same everywhere.
QWidget *portThatIsMissing(TrainingWindow &shown)
{
    shown.window().actions().findEncoders->trigger();
    auto *page = shown.window().findChild<FindPage *>();
    page->setPorts({{port, QStringLiteral("FT232R USB UART"), {}}}, {});
    const Refusal missing{RefusalKind::link, RefusalId::portNotFound, {port}};
    const Computer unknown(QStringLiteral("/there-is-none"));
    page->begin();
    page->add(refusedNews(port, missing));
    page->tell(troubleOf(*hindranceOf(missing, unknown)));
    page->end();
    shown.advance(whileMilliseconds);
    return page;
}

} // namespace

std::vector<Picture> finderPictures()
{
    return {pictureOf("find", findingIn), pictureOf("doctor", portThatIsMissing)};
}

} // namespace codewheel
