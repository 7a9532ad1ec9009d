<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Help</name>
    <message>
        <source>In five lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw the edges that you would see of a box, in any order; one stroke may draw several edges.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Edge Graph panel shows lines and corners as they are read; the drawing shows a faint preview.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lift the pen. When the reading is clear it becomes a solid; Enter does it at once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys 1 to 9 take another reading, also afterwards.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>If something does not meet, it is marked, with a button that repairs it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pen and mouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pen tip, or left button</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Erase a stroke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>eraser end of the pen, or the eraser tool (E)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel a stroke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Escape while drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right or middle button, Alt with left, pen&apos;s side button</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift with the middle button, Space with left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wheel, or two fingers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Z: the newest stroke first, then the newest step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quick help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About Edgewright</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns pen strokes into solids, step by step, with a topology library.

Free software under the GNU General Public License, version 3 or later, without any warranty. Uses Qt, VTK, OpenMesh, CGAL and Eigen.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ew::CandidateCard</name>
    <message>
        <source>add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading %1: %2, %3, fit %4 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ew::CandidatePanel</name>
    <message>
        <source>Apply &amp;by itself when clear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A&amp;pply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When one reading is clearly the best, it becomes a solid about a second after the pen is lifted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a solid of the chosen reading (Enter)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D&amp;epth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The front is taken as drawn. Depth is this many times the length of the slanted lines.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth of the oblique reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the drawing can mean appears here. Keys 1 to 9 choose.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Done. Another reading is one key away.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Done.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n reading(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ew::Document</name>
    <message>
        <source>Create %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Define template “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete solid</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ew::EditActions</name>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Clear ink</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Delete solid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drop all strokes that are no solid yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Pen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw strokes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Eraser</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove strokes; the eraser end of the pen does it too</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Orbit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the view; so do the right and the middle mouse button</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Move view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the view; so do Space with the left button and Shift with the middle one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo stroke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ew::FileActions</name>
    <message>
        <source>&amp;New</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a document or a sketch script</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the solid as OBJ, STL or PLY</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the changes to this document?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>They are lost otherwise.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open e&amp;xample</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save what was done as a s&amp;cript…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;creenshot…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are no examples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Documents and sketch scripts (*.edgewright *.json);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step %1 of the script (%2): %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edgewright document (*.edgewright)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved to %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save what was done as a script</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sketch script (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Script saved to %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wavefront OBJ, planar faces (*.obj);;STL, binary (*.stl);;PLY (*.ply)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exported to %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Screenshot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PNG (*.png)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture saved to %1.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ew::GraphPanel</name>
    <message numerus="yes">
        <source>%n face(s) seen</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>%1, fit %2 %, off by %3 px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nearest: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 missing, %2 too many</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No template yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing read yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n edge(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n junction(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ew::GraphView</name>
    <message>
        <source>Edge Graph</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines and corners appear here while you draw.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ew::HistoryPanel</name>
    <message>
        <source>History</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a step to go back or forward to it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Empty document</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ew::MainWindow</name>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Sketch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quick help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About Edgewright</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edge Graph</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thresholds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>T-LIB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tools</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1[*] – Edgewright</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ew::MessageBar</name>
    <message>
        <source>Message</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw the next shape.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw the edges that you would see of a box, a prism or a pyramid, in any order and with any number of strokes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 made.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n other reading(s): keys 1 to 9.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear: %1. Applying it; Escape waits.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear: %1. Enter makes it a solid.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chosen: %1. Enter makes it a solid.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading the drawing…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep drawing.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ew::SketchActions</name>
    <message>
        <source>&amp;Apply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply by &amp;itself when clear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add solid as &amp;template…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a solid of the drawing (Enter)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a solid without asking when one reading is clearly the best (A)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading &amp;%1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading &amp;%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading &amp;%1: %2, %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 can be drawn from now on.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ew::TemplateDialog</name>
    <message>
        <source>Add solid as template</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawings of this shape, in any proportion, will be read as it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Id</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Names the template in files and scripts: small letters, digits and hyphens.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is a template with this id already.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ew::TemplatePanel</name>
    <message>
        <source>Add &amp;solid as template…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Templates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open template f&amp;older</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A template file that is put there is used from the next start on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The solid on screen becomes a shape that drawings can match.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 vertices, %2 faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 parallel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 perpendicular</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 equal length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No relations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relations: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Also read as: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ew::ThresholdPanel</name>
    <message>
        <source>Reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far apart two stroke ends may be and still meet in one corner, and how far the eraser reaches. It is the ring round the pen tip.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An&amp;gle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much two lines may differ in direction and still count as parallel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to %1 px and %2°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 threshold</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ew::ViewActions</name>
    <message>
        <source>&amp;Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Hidden edges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show &amp;reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Start view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fr&amp;ont</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R&amp;ight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Botto&amp;m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show everything (F)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hidden edges as dashes (D)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show in the drawing what is read from it (R)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>T&amp;heme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;System</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ew::ViewportWidget</name>
    <message>
        <source>Drawing surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw with the pen or the left mouse button. The middle or right button orbits.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Turns pen strokes into solids.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
