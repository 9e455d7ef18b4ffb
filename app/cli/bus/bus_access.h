// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/answer.h"
#include "cli/call/complaint.h"
#include "cli/encoder/job_trace.h"
#include "cli/encoder/write_account.h"
#include "doctor/hindrance.h"
#include "vocabulary/exchange.h"
#include "vocabulary/parameter.h"

#include <QJsonObject>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

namespace codewheel {

class EncoderBus;
class LedgerKeeper;
struct Call;
struct FinishedJob;
struct Participant;
struct Project;
struct ProjectDevice;
struct Reading;
struct Subcommand;

// One bus of a call, as the commands use it. What is here works for any EncoderBus that is open; a kind of
// bus adds how its places are typed, how it is opened, and what only it can tell.
class BusAccess
{
public:
    explicit BusAccess(EncoderBus &bus, QString kind = {}); // the bus must outlive it
    virtual ~BusAccess();
    Q_DISABLE_COPY_MOVE(BusAccess)

    EncoderBus &bus() const { return m_bus; } // opened or not
    QString kind() const { return m_kind; }   // as in projects: "interbus"
    // BUS of BUS/PLACE: its name in the project, otherwise the name a new bus of its kind gets.
    QString name() const;
    void setName(const QString &name) { m_name = name; }

    // Counts EEPROM writes from now on: in the file, otherwise where those of this bus are counted; together
    // with those of the others that are counted there.
    void keepLedger(const std::optional<QString> &file, const std::vector<BusAccess *> &others = {});
    void setLedger(std::unique_ptr<LedgerKeeper> ledger);
    LedgerKeeper *ledger() const { return m_ledger.get(); } // null: none is kept

    // It is opened when it is first needed.
    virtual Checked<void> open() { return {}; }
    // What keeps its link from working, found without sending anything to an encoder.
    virtual Hindrances hindrances() const { return {}; }
    // Why the command does not work on this kind of bus at all; empty: it does.
    virtual std::optional<Complaint> whyNot(const Subcommand &) const { return std::nullopt; }

    // Whether a fault plan can act on it; from now on it does.
    virtual bool followsFaultPlan() const { return false; }
    virtual Checked<void> followFaultPlan(const QString &) { return {}; }

    // The place typed as `text`, whether there is a device or not; empty: no place is written like that.
    virtual std::optional<NodeId> placeTyped(const QString &text) const;
    // A device; as far as it is known without asking the bus: one that does not know its places has those of
    // the project and those asked for; without a project, any.
    virtual bool mayHave(NodeId node) const;
    virtual std::vector<Place> knownPlaces() const;               // likewise
    virtual bool knowsItsPlaces() const { return true; }          // otherwise others may be asked
    virtual bool isMeant(const QString &) const { return false; } // by its form, even if it is no place
    virtual Complaint notAPlace(const QString &typed) const;
    virtual QString somePlaces() const; // that exist, or how they are written
    // Whether the device that the project has at a station can be reached by that name.
    virtual Checked<void> checkStation(const Project &, const QString &) const { return {}; }
    // The encoder at the place, to the point that it shows its position; named by --device first.
    virtual Checked<EncoderSession *> encoder(const Call &call, NodeId node, bool namesIt);
    // Lets the encoder of the project show its position. That it is silent is no error.
    virtual Checked<void> contact(const Call &call, const ProjectDevice &planned);
    // Finds out whether it is there: if the bus does not know by itself, it is asked.
    virtual Checked<void> lookFor(const Call &, const ProjectDevice &) { return {}; }
    // It has what the project plans; its encoders may get the names they have there.
    virtual void useProject(const Call &call, const Project &project);

    // How much time passes between two looks at it.
    virtual Instant lookInterval() const { return std::chrono::milliseconds(10); }
    bool advance(Instant duration); // false: its link is gone
    // From now on the bus works by itself, at full speed beside all others; pump() takes what came. False: it
    // cannot, such as one in virtual time, and goes on with advance().
    virtual bool startThread() { return false; }
    bool isConnected() const;
    Complaint linkLost() const; // why it is gone
    // Why what it shows is old although it is connected; empty: it is not, or nobody tells.
    virtual std::optional<Complaint> whyItStands() const { return std::nullopt; }
    // About a job that was refused, and about the link if that is gone.
    virtual Complaint complaint(const Refusal &why) const { return complaintAbout(why); }

    // Before a job: what it depends on, and the encoder tells by itself before long.
    virtual void listenBefore(const EncoderSession &, const Job &) {}
    virtual void prepare(const Job &) {}              // it needs Operate, and the bus is in Watch
    virtual void rest() {}                            // after it, or the last of several
    virtual void lookAgain(const EncoderSession &) {} // after it: the position is to be from then
    virtual std::unique_ptr<JobTrace> trace(const std::vector<const EncoderSession *> &encoders);
    // The words of the last cycle; empty: it has no words.
    virtual std::optional<Exchange> currentRow(const EncoderSession &) const { return std::nullopt; }

    virtual bool tellsVersion() const { return false; }              // whether its encoders report one
    virtual QString versionOf(const EncoderSession &) { return {}; } // as text; empty: it reports none
    // Reads what is about to be written, where reading disturbs nothing: so what is shown is what is sent.
    virtual Checked<void> readBefore(const Call &, EncoderSession &, const ParameterValues &) { return {}; }
    // The same, and whether anything prevents writing.
    virtual Checked<void> prepareWrite(const Call &, EncoderSession &, const ParameterValues &) { return {}; }
    virtual std::unique_ptr<WriteAccount>
    account(const EncoderSession &encoder, const ParameterValues &wanted, const FinishedJob &job) const;
    // What has to be typed from now on to reach an encoder that has these values.
    virtual QString whereItIsNow(const EncoderSession &, const ParameterValues &) const { return {}; }

    // What a reading says besides its position, as text and for programs.
    virtual QStringList remarks(const Reading &reading) const;
    virtual QJsonObject remarksJson(const Reading &) const { return {}; }
    // After a watch, the statistics of the bus.
    virtual void addFigures(const Call &, const EncoderSession &, Answer &) const {}

    // What the bus reports of a device, and the key of its description (null: not known). ID code, words and
    // level are those of a ring, and 0 elsewhere.
    virtual QJsonObject participantJson(const Participant &device) const;
    virtual Checked<void> checkScan(const Call &) const { return {}; } // whether its options are valid
    // What is on the bus, as found now.
    virtual Checked<Answer> scan(const Call &call);
    // Whether the search is complete and nobody answered: what is planned may merely be switched off.
    virtual bool hasFoundNobody() const { return false; }
    // Puts what was found into the plan, which already has this bus.
    virtual void keepFound(const Call &call, Project &project) const;

    virtual Refusal whatIsLost() const; // why its link is gone, in its own words if it gave any
    // How long what it shows is, such as a log; empty: as long as somebody looks.
    virtual std::optional<Instant> length() const { return std::nullopt; }

private:
    EncoderBus &m_bus;
    QString m_kind;
    QString m_name;
    std::optional<std::vector<NodeId>> m_planned; // of the project of the call
    std::unique_ptr<LedgerKeeper> m_ledger;
};

} // namespace codewheel
