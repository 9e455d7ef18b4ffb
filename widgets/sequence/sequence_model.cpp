// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sequence/sequence_model.h"

#include "catalog/explain_word.h"
#include "vocabulary/hex.h"
#include "widgets/look/fonts.h"
#include "widgets/look/icons.h"
#include "widgets/look/roles.h"
#include "widgets/monitor/word_format.h"

namespace codewheel {

std::vector<Word> SequenceModel::words() const
{
    std::vector<Word> all;
    for (const SequenceRow &row : rows())
        all.push_back(row.word);
    return all;
}

void SequenceModel::setWords(const std::vector<Word> &words)
{
    std::vector<SequenceRow> all;
    all.reserve(words.size());
    for (const Word each : words)
        all.push_back({.word = each});
    setRows(std::move(all));
}

void SequenceModel::setDevice(const DeviceDescription *device, std::optional<Mode> mode)
{
    if (m_device == device && m_mode == mode)
        return;
    m_device = device;
    m_mode = mode;
    if (rowCount() > 0)
        Q_EMIT dataChanged(index(0, meaning), index(rowCount() - 1, meaning));
}

void SequenceModel::setSendingRow(std::optional<int> row)
{
    for (int i = 0; i < rowCount(); ++i) {
        const auto wanted = !row || i > *row ? SequenceRow::State::waiting
                            : i < *row       ? SequenceRow::State::sent
                                             : SequenceRow::State::sending;
        if (rowAt(i).state != wanted)
            replace(i, {.word = rowAt(i).word, .state = wanted});
    }
}

void SequenceModel::setLocked(bool locked)
{
    m_locked = locked;
}

void SequenceModel::moveRowTo(int row, int to)
{
    const SequenceRow moved = rowAt(row);
    removeAt(row);
    insertAt(to, moved);
}

Qt::ItemFlags SequenceModel::flags(const QModelIndex &index) const
{
    const Qt::ItemFlags usual = TableModelBase::flags(index);
    return index.column() == word && !m_locked ? usual | Qt::ItemIsEditable : usual;
}

bool SequenceModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (!index.isValid() || role != Qt::EditRole || !(flags(index) & Qt::ItemIsEditable))
        return false;
    const QString text = value.toString();
    const std::optional<Word> typed = parseHexWord(text);
    if (!typed) {
        Q_EMIT badInput(hexProblem(text));
        return false;
    }
    replace(index.row(), {.word = *typed});
    return true;
}

std::span<const ColumnHead> SequenceModel::heads() const
{
    static constexpr ColumnHead all[] = {{QT_TR_NOOP("Word"), Qt::AlignLeft},
                                         {QT_TR_NOOP("Meaning"), Qt::AlignLeft},
                                         {QT_TR_NOOP("State"), Qt::AlignLeft}};
    return all;
}

QString SequenceModel::explain(Word content) const
{
    if (!m_device)
        return {};
    WordContext context;
    context.direction = WordDirection::out;
    context.mode = m_mode;
    return explanationText(*m_device, explainWord(*m_device, content, context));
}

QString SequenceModel::text(const SequenceRow &row, int column) const
{
    if (column != state)
        return column == word ? hexWord(row.word) : explain(row.word);
    return row.state == SequenceRow::State::sending ? tr("Sending")
           : row.state == SequenceRow::State::sent  ? tr("Sent")
                                                    : QString();
}

QVariant SequenceModel::cell(const SequenceRow &row, int column, int role) const
{
    if (role == Qt::EditRole && column == word)
        return text(row, column);
    if (role != Qt::DecorationRole || column != state || row.state == SequenceRow::State::waiting)
        return TableModelBase::cell(row, column, role);
    return row.state == SequenceRow::State::sending ? lineIcon(Icon::next, Role::attention)
                                                    : lineIcon(Icon::ok, Role::running);
}

} // namespace codewheel
