// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "project/word_list.h"
#include "vocabulary/mode.h"
#include "widgets/models/table_model_base.h"

namespace codewheel {

struct SequenceRow
{
    enum class State : std::uint8_t { waiting, sending, sent };

    Word word = 0;
    State state = State::waiting;
};

// The words of a sequence, each with its meaning for the encoder it would go to, and the progress of sending.
class SequenceModel : public TableModelBase<SequenceRow>
{
    Q_OBJECT

public:
    enum Column { word, meaning, state };

    using TableModelBase::TableModelBase;

    std::vector<Word> words() const;
    void setWords(const std::vector<Word> &words);
    // Null: no encoder; words are not explained. The description must outlive its use here.
    void setDevice(const DeviceDescription *device, std::optional<Mode> mode);
    // The words before this row have been sent, those after it wait; nothing: all wait.
    void setSendingRow(std::optional<int> row);
    void setLocked(bool locked); // while it is being sent
    void moveRowTo(int row, int to);

    Qt::ItemFlags flags(const QModelIndex &index) const override;
    // Hexadecimal; anything else changes nothing and is reported by badInput().
    bool setData(const QModelIndex &index, const QVariant &value, int role = Qt::EditRole) override;

Q_SIGNALS:
    void badInput(const QString &sentence);

protected:
    std::span<const ColumnHead> heads() const override;
    QString text(const SequenceRow &row, int column) const override;
    bool isNumber(int column) const override { return column == word; }
    QVariant cell(const SequenceRow &row, int column, int role) const override;

private:
    QString explain(Word content) const;

    const DeviceDescription *m_device = nullptr;
    std::optional<Mode> m_mode;
    bool m_locked = false;
};

} // namespace codewheel
