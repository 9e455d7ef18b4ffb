// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_frame.h"
#include "kinds/canopen/protocol/sdo.h"
#include "vocabulary/find_by.h"

#include <functional>
#include <span>
#include <vector>

namespace codewheel::canopen {

struct PdoEntry
{
    SdoObject object{};
    int bits = 0;
    int firstBit = 0; // in the frame

    // One of the types that can be mapped to leave room.
    bool isDummy() const { return object.index >= 0x0001 && object.index <= 0x0007; }

    friend bool operator==(const PdoEntry &, const PdoEntry &) = default;
};

// What is known of an object that is mapped.
struct PdoType
{
    bool isSigned = false;
    std::optional<int> bits{}; // as its answers by SDO have; empty: not known
};

struct PdoValue
{
    SdoObject object{};
    int bits = 0;
    std::uint64_t raw = 0;
    std::int64_t number = 0; // of what is not signed the same as raw
};

// A PDO that a node sends as the node says, by its objects 18xxh and 1Axxh, and what a frame with it means.
class PdoMapping
{
public:
    static constexpr int mostEntries = 64;

    explicit PdoMapping(int number); // 1 to 512

    int number() const { return m_number; }
    bool holds(const SdoObject &object) const; // as far as it was read

    // What has not been told yet, to be read in this order; which entries there are follows from their count.
    const std::vector<SdoObject> &missing() const { return m_missing; }
    // Whether the object belongs to this PDO. One that the node does not have has no octets.
    bool take(const SdoObject &object, Octets value);
    bool isRead() const { return m_missing.empty(); }

    // Without identifier and count there is no such PDO.
    bool isThere() const { return m_identifier && number(mappingObject(0)); }
    bool isOff() const;
    bool hasIdentifier() const { return m_identifier.has_value(); } // it was told
    bool hasAllEntries() const { return m_hasAllEntries; }
    std::uint32_t identifier() const; // of 11 or 29 bits
    bool isExtended() const;          // 29 bits
    std::optional<int> type() const;  // 0 acyclic, 1..240 each n-th SYNC, 252 to 255
    std::optional<Instant> inhibitTime() const;
    std::optional<Instant> eventTimer() const; // 0: off
    const std::vector<PdoEntry> &entries() const { return m_entries; }

    bool isOf(const CanFrame &frame) const;
    // The entries that can be read, without the dummies. From one on that does not fit its object nothing
    // can: where the next one begins is not known. A frame shorter than the mapping says nothing.
    std::vector<PdoValue> values(const CanFrame &frame,
                                 const std::function<PdoType(const SdoObject &)> &typeOf) const;

private:
    struct Told
    {
        SdoObject object;
        std::optional<std::uint32_t> number; // empty: the node does not have it
    };

    SdoObject settingsObject(int sub) const;
    SdoObject mappingObject(int sub) const;
    const Told *told(const SdoObject &object) const { return findBy(m_told, object, &Told::object); }
    std::optional<std::uint32_t> number(const SdoObject &object) const;
    int count() const;
    void place();
    void lookForMissing();

    int m_number;
    std::vector<Told> m_told{};
    std::optional<std::uint32_t> m_identifier{}; // with its bits
    std::vector<PdoEntry> m_entries{};
    bool m_hasAllEntries = false;
    std::vector<SdoObject> m_missing{};
};

// When the PDO with an object comes, as its node told it.
struct PdoTerms
{
    int number = 0;
    std::uint32_t identifier = 0;
    bool isOff = false;
    std::optional<int> type{};           // 0 acyclic, 1..240 each n-th SYNC, 252 to 255
    std::optional<Instant> eventTimer{}; // 0: it is sent on change alone
    std::optional<Instant> inhibitTime{};
    bool holdsIt = false; // otherwise none does, and these are those of the first one

    bool isSynchronous() const { return type && *type <= 240; }
    bool isAskedFor() const { return type && (*type == 252 || *type == 253); }
    bool isOnChange() const { return !isSynchronous() && !isAskedFor() && eventTimer == Instant::zero(); }
};

// Empty: they are not all read, or there is none.
std::optional<PdoTerms> termsOf(std::span<const PdoMapping> pdos, const SdoObject &object);

} // namespace codewheel::canopen
