<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>ew::CandidateCard</name>
    <message numerus="yes">
        <source>%n stroke(s) not explained</source>
        <translation>
            <numerusform>%n stroke not explained</numerusform>
            <numerusform>%n strokes not explained</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) not explained</source>
        <translation>
            <numerusform>%n line not explained</numerusform>
            <numerusform>%n lines not explained</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n edge(s) not drawn</source>
        <translation>
            <numerusform>%n edge not drawn</numerusform>
            <numerusform>%n edges not drawn</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ew::CandidatePanel</name>
    <message numerus="yes">
        <source>%n reading(s)</source>
        <translation>
            <numerusform>%n reading</numerusform>
            <numerusform>%n readings</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ew::GraphPanel</name>
    <message numerus="yes">
        <source>outline on %n face(s)</source>
        <translation>
            <numerusform>outline on %n face</numerusform>
            <numerusform>outline on %n faces</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>seen through %n face(s)</source>
        <translation>
            <numerusform>seen through %n face</numerusform>
            <numerusform>seen through %n faces</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n face(s) seen</source>
        <translation>
            <numerusform>%n face seen</numerusform>
            <numerusform>%n faces seen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n edge(s)</source>
        <translation>
            <numerusform>%n edge</numerusform>
            <numerusform>%n edges</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n junction(s)</source>
        <translation>
            <numerusform>%n junction</numerusform>
            <numerusform>%n junctions</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Every line is there, %n end(s) open</source>
        <translation>
            <numerusform>Every line is there, %n end open</numerusform>
            <numerusform>Every line is there, %n ends open</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ew::HistoryPanel</name>
    <message numerus="yes">
        <source>Step %1 was changed, and %n step(s) after it done again.</source>
        <translation>
            <numerusform>Step %1 was changed, and %n step after it done again.</numerusform>
            <numerusform>Step %1 was changed, and %n steps after it done again.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Step %1 was changed. %n step(s) after it no longer fit and were left out; the strokes that they had used are kept.</source>
        <translation>
            <numerusform>Step %1 was changed. %n step after it no longer fits and was left out; the strokes that it had used are kept.</numerusform>
            <numerusform>Step %1 was changed. %n steps after it no longer fit and were left out; the strokes that they had used are kept.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ew::MessageBar</name>
    <message numerus="yes">
        <source>%n other reading(s): keys 1 to 9.</source>
        <translation>
            <numerusform>%n other reading: keys 1 to 9.</numerusform>
            <numerusform>%n other readings: keys 1 to 9.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) that it does not use stay.</source>
        <translation>
            <numerusform>%n stroke that it does not use stays.</numerusform>
            <numerusform>%n strokes that it does not use stay.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ew::OverviewDialog</name>
    <message numerus="yes">
        <source>%n pupil(s)</source>
        <translation>
            <numerusform>%n pupil</numerusform>
            <numerusform>%n pupils</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stuck</source>
        <translation>
            <numerusform>%n stuck</numerusform>
            <numerusform>%n stuck</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more file(s) cannot be read.</source>
        <translation>
            <numerusform>%n more file cannot be read.</numerusform>
            <numerusform>%n more files cannot be read.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ew::RecoverDialog</name>
    <message numerus="yes">
        <source>%n step(s)</source>
        <translation>
            <numerusform>%n step</numerusform>
            <numerusform>%n steps</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) waiting</source>
        <translation>
            <numerusform>%n stroke waiting</numerusform>
            <numerusform>%n strokes waiting</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ew::StartPage</name>
    <message numerus="yes">
        <source>%n step(s)</source>
        <translation>
            <numerusform>%n step</numerusform>
            <numerusform>%n steps</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) waiting</source>
        <translation>
            <numerusform>%n stroke waiting</numerusform>
            <numerusform>%n strokes waiting</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ew::WorkKeeper</name>
    <message numerus="yes">
        <source>Recovered: %n step(s), as of %1.</source>
        <translation>
            <numerusform>Recovered: %n step, as of %1.</numerusform>
            <numerusform>Recovered: %n steps, as of %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ShapeSources</name>
    <message numerus="yes">
        <source>over %n corner(s)</source>
        <translation>
            <numerusform>over %n corner</numerusform>
            <numerusform>over %n corners</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ew::AspectList</name>
    <message numerus="yes">
        <source>opening of %n face(s)</source>
        <translation>
            <numerusform>opening of %n face</numerusform>
            <numerusform>opening of %n faces</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n face(s)</source>
        <translation>
            <numerusform>%n face</numerusform>
            <numerusform>%n faces</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ew::TemplateEditor</name>
    <message numerus="yes">
        <source>%n proportion(s) stay open; what a drawing does not tell is taken from this shape.</source>
        <translation>
            <numerusform>%n proportion stays open; what a drawing does not tell is taken from this shape.</numerusform>
            <numerusform>%n proportions stay open; what a drawing does not tell is taken from this shape.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n view(s) that it is read from</source>
        <translation>
            <numerusform>%n view that it is read from</numerusform>
            <numerusform>%n views that it is read from</numerusform>
        </translation>
    </message>
</context>
</TS>
