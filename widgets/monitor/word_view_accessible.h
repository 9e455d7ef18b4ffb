// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/monitor/word_layout.h"

#include <QAccessibleWidget>
#include <QPointer>

#include <unordered_map>

namespace codewheel {

class WordView;

// Makes Qt ask us for the accessibility of WordView; may be called any number of times.
void installWordViewAccessibility();

void announceBitFocus(WordView &view, WordBit bit);
void announceBitState(WordView &view, WordBit bit);

// A WordView as assistive technology sees it: a group of check boxes, word by word, the highest bit
// first.
class WordViewAccessible final : public QAccessibleWidget
{
public:
    explicit WordViewAccessible(WordView &view);
    ~WordViewAccessible() override;
    WordViewAccessible(const WordViewAccessible &) = delete;
    WordViewAccessible &operator=(const WordViewAccessible &) = delete;

    int childCount() const override;
    QAccessibleInterface *child(int index) const override;
    QAccessibleInterface *childAt(int x, int y) const override;
    int indexOfChild(const QAccessibleInterface *child) const override;
    QAccessibleInterface *focusChild() const override;

private:
    WordView &view() const;

    mutable std::unordered_map<int, QAccessible::Id> m_bits; // by index, made when first asked for
};

// One bit: a check box; with a toggle action if the word is editable.
class BitAccessible final : public QAccessibleInterface, public QAccessibleActionInterface
{
public:
    BitAccessible(WordView &view, WordBit bit);

    WordBit bit() const { return m_bit; }

    bool isValid() const override;
    QObject *object() const override { return nullptr; } // the view's object is the group
    QWindow *window() const override;
    QAccessibleInterface *parent() const override;
    QAccessibleInterface *child(int) const override { return nullptr; }
    QAccessibleInterface *childAt(int, int) const override { return nullptr; }
    int childCount() const override { return 0; }
    int indexOfChild(const QAccessibleInterface *) const override { return -1; }
    QString text(QAccessible::Text text) const override;
    void setText(QAccessible::Text, const QString &) override {}
    QRect rect() const override;
    QAccessible::Role role() const override { return QAccessible::CheckBox; }
    QAccessible::State state() const override;
    void *interface_cast(QAccessible::InterfaceType type) override;

    QStringList actionNames() const override;
    void doAction(const QString &name) override;
    QStringList keyBindingsForAction(const QString &name) const override;

private:
    QPointer<WordView> m_view;
    WordBit m_bit;
};

} // namespace codewheel
