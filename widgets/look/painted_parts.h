// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAccessible>
#include <QPoint>
#include <QRect>
#include <QString>

#include <optional>

class QWidget;

namespace codewheel {

// A painted widget whose parts are separate controls for assistive technology: a group of check boxes. A
// widget inherits this besides QWidget, and calls installPaintedPartsAccessibility() in its constructor.
class PaintedParts
{
public:
    virtual ~PaintedParts() = default;

    virtual int partCount() const = 0;
    virtual QString partName(int part) const = 0;
    virtual QString partDescription(int part) const = 0;
    virtual QRect partRect(int part) const = 0; // in the widget
    virtual std::optional<int> partAt(QPoint point) const;
    virtual bool isPartChecked(int part) const = 0;
    virtual bool isPartEditable(int) const { return true; }
    virtual int focusedPart() const = 0;
    virtual void focusPart(int part) = 0;
    virtual void togglePart(int part) = 0;
};

// Makes Qt ask us for the accessibility of such widgets; may be called any number of times.
void installPaintedPartsAccessibility();

// To be called when focusedPart() has changed, or a part was checked or unchecked.
void announcePartFocus(QWidget &widget, int part);
void announcePartState(QWidget &widget, int part);

} // namespace codewheel
