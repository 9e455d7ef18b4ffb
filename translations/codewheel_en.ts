<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
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
        <source>%n late cycles</source>
        <translation>
            <numerusform>%n late cycle</numerusform>
            <numerusform>%n late cycles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 %2: %n writes from here</source>
        <translation>
            <numerusform>%1 %2: %n write from here</numerusform>
            <numerusform>%1 %2: %n writes from here</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::TraceView</name>
    <message numerus="yes">
        <source>%n rows</source>
        <translation>
            <numerusform>%n row</numerusform>
            <numerusform>%n rows</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>paused, %n new</source>
        <translation>
            <numerusform>paused, %n new</numerusform>
            <numerusform>paused, %n new</numerusform>
        </translation>
    </message>
</context>
</TS>
