// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/complaint.h"
#include "drivers/esc_settings.h"
#include "drivers/value_notes.h"
#include "encoder/encoder_session.h"

#include <QJsonArray>

#include <vector>

namespace codewheel {

struct ParameterDescription;

// What `write` is about to do, shown before anything is written: each value, what is known of it, and the
// word, or the command on a serial line, that will carry it.
class WritePlan
{
public:
    struct Row
    {
        const ParameterDescription *parameter;
        std::int64_t wanted = 0;
        std::optional<Known> known;
        QString sent;           // the word; on a serial line the command
        bool leftOut = false;   // known to be there already
        bool goesAlong = false; // computed from the others, and sent with them
    };

    // Refuses what the encoder does not have or cannot take. With `all`, nothing is left out.
    static Checked<WritePlan> make(const EncoderSession &encoder, const ParameterValues &wanted, bool all,
                                   const EscSettings &escSettings = {});

    // What the job is to write, in the order given.
    WriteParameters job() const;
    bool isEmpty() const { return job().values.empty(); }

    QString toText() const;
    QJsonArray toJson() const;
    QJsonArray notesJson() const; // [{"key", "arguments", "text"}]

private:
    WritePlan(const EncoderSession &encoder, bool all);
    QString notes() const;
    std::vector<ValueNote> valueNotes() const;
    bool isRod() const;
    bool isOnLine() const { return m_encoder.number().isOnLine(); }
    void addWhatGoesAlong(const std::vector<Step> &steps, const ParameterValues &wanted);

    const EncoderSession &m_encoder;
    bool m_readsFirst;          // the job asks the encoder and leaves out what it has
    bool m_stepsMinusOneIsOpen; // the word of steps depends on a flag that is not known
    std::vector<Row> m_rows;
};

} // namespace codewheel
