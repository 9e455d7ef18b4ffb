// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/place.h"

#include <QPicture>
#include <QPointer>
#include <QSize>

#include <optional>
#include <utility>
#include <vector>

class QAbstractItemView;
class QWidget;

namespace codewheel {

// Lines, areas and letters as they were drawn, so that they are sharp on any printer; in logical pixels.
struct PrintedPicture
{
    QPicture drawing;
    QSize size;
};

// Draws a widget that was made for it, in dark letters on white whatever the screen has.
PrintedPicture drawnOnPaper(QWidget &view, QSize size);

// What a view with a picture gives to be printed, as it is at that moment.
struct PrintedView
{
    QString title; // "Cams"
    Place place;   // whose it is; empty: of several
    QString device;
    std::vector<PrintedPicture> pictures{};
    std::vector<std::pair<QString, QString>> values{}; // name and value
    QPointer<const QAbstractItemView> table{};         // below the values; null: none
};

// A view that is printed as a picture with its values, and not as the first table in it.
class PrintsPicture
{
public:
    virtual ~PrintsPicture() = default;
    virtual std::optional<PrintedView> printedView() const = 0; // nothing: it shows nothing now
};

} // namespace codewheel
