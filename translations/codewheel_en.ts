<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>StructureSteps</name>
    <message numerus="yes">
        <source>Remove %n devices</source>
        <translation>
            <numerusform>Remove %n device</numerusform>
            <numerusform>Remove %n devices</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move %n devices</source>
        <translation>
            <numerusform>Move %n device</numerusform>
            <numerusform>Move %n devices</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::BusList</name>
    <message numerus="yes">
        <source>All that is planned and known of the %n devices of &quot;%1&quot; leaves the project with it. What is connected is not touched.</source>
        <translation>
            <numerusform>All that is planned and known of the %n device of &quot;%1&quot; leaves the project with it. What is connected is not touched.</numerusform>
            <numerusform>All that is planned and known of the %n devices of &quot;%1&quot; leaves the project with it. What is connected is not touched.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>&amp;Remove &quot;%1&quot; and its %n devices</source>
        <translation>
            <numerusform>&amp;Remove &quot;%1&quot; and its %n device</numerusform>
            <numerusform>&amp;Remove &quot;%1&quot; and its %n devices</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::CanSearchPage</name>
    <message numerus="yes">
        <source>Nodes found: %n.</source>
        <translation>
            <numerusform>Nodes found: %n.</numerusform>
            <numerusform>Nodes found: %n.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::CommandPalette</name>
    <message numerus="yes">
        <source>%n found</source>
        <translation>
            <numerusform>%n found</numerusform>
            <numerusform>%n found</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::ComparisonPage</name>
    <message numerus="yes">
        <source>%n lines differ.</source>
        <translation>
            <numerusform>%n line differs.</numerusform>
            <numerusform>%n lines differ.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lines differed.</source>
        <translation>
            <numerusform>%n line differed.</numerusform>
            <numerusform>%n lines differed.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::DataCheck</name>
    <message numerus="yes">
        <source>%n devices</source>
        <translation>
            <numerusform>%n device</numerusform>
            <numerusform>%n devices</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::DroppedFiles</name>
    <message numerus="yes">
        <source>%n files were dropped. Drop one at a time.</source>
        <translation>
            <numerusform>%n file was dropped. Drop one at a time.</numerusform>
            <numerusform>%n files were dropped. Drop one at a time.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::EscLineCheck</name>
    <message numerus="yes">
        <source>%n bytes came before anything was asked: another master works on this line, or something sends by itself. Nothing was sent.</source>
        <translation>
            <numerusform>%n byte came before anything was asked: another master works on this line, or something sends by itself. Nothing was sent.</numerusform>
            <numerusform>%n bytes came before anything was asked: another master works on this line, or something sends by itself. Nothing was sent.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n bytes came, but no answer of an encoder. Check baud rate and format, and whether two encoders answer at once.</source>
        <translation>
            <numerusform>%n byte came, but no answer of an encoder. Check baud rate and format, and whether two encoders answer at once.</numerusform>
            <numerusform>%n bytes came, but no answer of an encoder. Check baud rate and format, and whether two encoders answer at once.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::EscLineChecks</name>
    <message numerus="yes">
        <source>none for %n requests</source>
        <translation>
            <numerusform>none for %n request</numerusform>
            <numerusform>none for %n requests</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n bytes that are no answer</source>
        <translation>
            <numerusform>%n byte that is no answer</numerusform>
            <numerusform>%n bytes that are no answer</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::EscLineRecordView</name>
    <message numerus="yes">
        <source>and %n more, listed below</source>
        <translation>
            <numerusform>and %n more, listed below</numerusform>
            <numerusform>and %n more, listed below</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::EscLineSearch</name>
    <message numerus="yes">
        <source>Requests sent: %n.</source>
        <translation>
            <numerusform>Requests sent: %n.</numerusform>
            <numerusform>Requests sent: %n.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Encoders found: %n.</source>
        <translation>
            <numerusform>Encoders found: %n.</numerusform>
            <numerusform>Encoders found: %n.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::FaultBanner</name>
    <message numerus="yes">
        <source>%n more</source>
        <comment>faults</comment>
        <translation>
            <numerusform>%n more</numerusform>
            <numerusform>%n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::FaultPlanBar</name>
    <message numerus="yes">
        <source>%1: %n steps</source>
        <translation>
            <numerusform>%1: %n step</numerusform>
            <numerusform>%1: %n steps</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::HelpSidebar</name>
    <message numerus="yes">
        <source>%n sections</source>
        <translation>
            <numerusform>%n section</numerusform>
            <numerusform>%n sections</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::MasterPanel</name>
    <message numerus="yes">
        <source>%n devices found</source>
        <translation>
            <numerusform>%n device found</numerusform>
            <numerusform>%n devices found</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 and %n more</numerusform>
            <numerusform>%1 and %n more</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The outputs of %n devices go to 0.</source>
        <translation>
            <numerusform>The outputs of %n device go to 0.</numerusform>
            <numerusform>The outputs of %n devices go to 0.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::MessagesView</name>
    <message numerus="yes">
        <source>%n found</source>
        <translation>
            <numerusform>%n found</numerusform>
            <numerusform>%n found</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::OfferFiles</name>
    <message numerus="yes">
        <source>%n files saved in %1. %2</source>
        <translation>
            <numerusform>%n file saved in %1. %2</numerusform>
            <numerusform>%n files saved in %1. %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n files of these names are there already.</source>
        <translation>
            <numerusform>%n file of this name is there already.</numerusform>
            <numerusform>%n files of these names are there already.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::OfferViews</name>
    <message numerus="yes">
        <source>%n clients</source>
        <translation>
            <numerusform>%n client</numerusform>
            <numerusform>%n clients</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::OfferedView</name>
    <message numerus="yes">
        <source>Units 1 to %n are the seats, each with a ring of its own. The ring of this window is not offered.</source>
        <translation>
            <numerusform>Unit %n is the only seat, with a ring of its own. The ring of this window is not offered.</numerusform>
            <numerusform>Units 1 to %n are the seats, each with a ring of its own. The ring of this window is not offered.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::OperateQuestion</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::ReportTexts</name>
    <message numerus="yes">
        <source>%n wanted value(s) or cam program(s) could not be compared: what the encoders have there is unknown.</source>
        <translation>
            <numerusform>%n wanted value or cam program could not be compared: what the encoder has there is unknown.</numerusform>
            <numerusform>%n wanted values or cam programs could not be compared: what the encoders have there is unknown.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::RingComparison</name>
    <message numerus="yes">
        <source>The ring is planned as the master keeps it: %1, %n devices.</source>
        <translation>
            <numerusform>The ring is planned as the master keeps it: %1, %n device.</numerusform>
            <numerusform>The ring is planned as the master keeps it: %1, %n devices.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The master keeps %1 with %n devices.</source>
        <translation>
            <numerusform>The master keeps %1 with %n device.</numerusform>
            <numerusform>The master keeps %1 with %n devices.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Loaded back, %n lines differ from the project.</source>
        <translation>
            <numerusform>Loaded back, %n line differs from the project.</numerusform>
            <numerusform>Loaded back, %n lines differ from the project.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::RingConnection</name>
    <message numerus="yes">
        <source>Reading in the ring: %n devices found.</source>
        <translation>
            <numerusform>Reading in the ring: %n device found.</numerusform>
            <numerusform>Reading in the ring: %n devices found.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::RingStatus</name>
    <message numerus="yes">
        <source>%n late cycles</source>
        <translation>
            <numerusform>%n late cycle</numerusform>
            <numerusform>%n late cycles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n CRC errors</source>
        <translation>
            <numerusform>%n CRC error</numerusform>
            <numerusform>%n CRC errors</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::SegmentModel</name>
    <message numerus="yes">
        <source>%n errors in the last five minutes</source>
        <translation>
            <numerusform>%n error in the last five minutes</numerusform>
            <numerusform>%n errors in the last five minutes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::SequenceView</name>
    <message numerus="yes">
        <source>All %n words were sent.</source>
        <translation>
            <numerusform>%n word was sent.</numerusform>
            <numerusform>All %n words were sent.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n words to %1</source>
        <translation>
            <numerusform>%n word to %1</numerusform>
            <numerusform>%n words to %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::StatusLine</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <comment>fault of a bus</comment>
        <translation>
            <numerusform>%1 and %n more</numerusform>
            <numerusform>%1 and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::StructureEditor</name>
    <message numerus="yes">
        <source>%n devices with findings</source>
        <translation>
            <numerusform>%n device with findings</numerusform>
            <numerusform>%n devices with findings</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::SupportDialog</name>
    <message numerus="yes">
        <source>%n files, %1 uncompressed</source>
        <translation>
            <numerusform>%n file, %1 before it is compressed</numerusform>
            <numerusform>%n files, %1 before they are compressed</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::TrafficModel</name>
    <message numerus="yes">
        <source>%Ln rows</source>
        <translation>
            <numerusform>%Ln row</numerusform>
            <numerusform>%Ln rows</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>paused, %Ln new</source>
        <translation>
            <numerusform>paused, %Ln new</numerusform>
            <numerusform>paused, %Ln new</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::TrendPage</name>
    <message numerus="yes">
        <source>No more than %n curves can be shown. Remove one first.</source>
        <translation>
            <numerusform>No more than %n curve can be shown. Remove it first.</numerusform>
            <numerusform>No more than %n curves can be shown. Remove one first.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n cycles came too fast and are missing</source>
        <translation>
            <numerusform>%n cycle came too fast and is missing</numerusform>
            <numerusform>%n cycles came too fast and are missing</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 is written: %n rows; the file beside it says what they are.</source>
        <translation>
            <numerusform>%1 is written: %n row; the file beside it says what it is.</numerusform>
            <numerusform>%1 is written: %n rows; the file beside it says what they are.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::UnseenFaults</name>
    <message numerus="yes">
        <source>%n faults, the last: %1</source>
        <comment>place</comment>
        <translation>
            <numerusform>%n fault, the last: %1</numerusform>
            <numerusform>%n faults, the last: %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::WindowActions</name>
    <message numerus="yes">
        <source>&amp;ALARM STOP %n buses</source>
        <translation>
            <numerusform>&amp;ALARM STOP %n bus</numerusform>
            <numerusform>&amp;ALARM STOP %n buses</numerusform>
        </translation>
    </message>
</context>
</TS>
