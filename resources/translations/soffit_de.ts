<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Application</name>
    <message>
        <source>Interactive, converged light for indoor architecture</source>
        <translation>Interaktives, auskonvergiertes Licht für Innenräume</translation>
    </message>
    <message>
        <source>Project or model to open</source>
        <translation>Zu öffnendes Projekt oder Modell</translation>
    </message>
</context>
<context>
    <name>Core</name>
    <message>
        <source>reading models</source>
        <translation>Modelle lesen</translation>
    </message>
    <message>
        <source>reading the model</source>
        <translation>Modell lesen</translation>
    </message>
    <message>
        <source>cleaning the model</source>
        <translation>Modell bereinigen</translation>
    </message>
    <message>
        <source>preparing geometry</source>
        <translation>Geometrie vorbereiten</translation>
    </message>
    <message>
        <source>looking for a stored bake</source>
        <translation>gespeicherte Vorberechnung suchen</translation>
    </message>
    <message>
        <source>laying out texels</source>
        <translation>Rechenpunkte verteilen</translation>
    </message>
    <message>
        <source>tracing surfaces</source>
        <translation>Flächen abtasten</translation>
    </message>
    <message>
        <source>training lights</source>
        <translation>Übungsleuchten rechnen</translation>
    </message>
    <message>
        <source>looking where light differs</source>
        <translation>Lichtunterschiede suchen</translation>
    </message>
    <message>
        <source>tracing gather rays</source>
        <translation>Sammelstrahlen verfolgen</translation>
    </message>
    <message>
        <source>storing the bake</source>
        <translation>Vorberechnung speichern</translation>
    </message>
    <message>
        <source>looking for the sky</source>
        <translation>Himmel suchen</translation>
    </message>
    <message>
        <source>computing luminaires</source>
        <translation>Leuchten berechnen</translation>
    </message>
    <message>
        <source>comparing layouts</source>
        <translation>Varianten vergleichen</translation>
    </message>
    <message>
        <source>tracing reference paths</source>
        <translation>Referenzpfade verfolgen</translation>
    </message>
    <message>
        <source>direct light</source>
        <translation>direktes Licht</translation>
    </message>
    <message>
        <source>no luminaire is on</source>
        <translation>keine Leuchte ist eingeschaltet</translation>
    </message>
    <message>
        <source>interreflection</source>
        <translation>Mehrfachreflexion</translation>
    </message>
    <message>
        <source>no surface reflects</source>
        <translation>keine Fläche reflektiert</translation>
    </message>
    <message>
        <source>visibility</source>
        <translation>Verschattung</translation>
    </message>
    <message>
        <source>there is no geometry</source>
        <translation>es gibt keine Geometrie</translation>
    </message>
    <message>
        <source>three color channels</source>
        <translation>drei Farbkanäle</translation>
    </message>
    <message>
        <source>all reflectances are grey</source>
        <translation>alle Reflexionsgrade sind unbunt</translation>
    </message>
    <message>
        <source>highlights and reflections</source>
        <translation>Glanzlichter und Spiegelungen</translation>
    </message>
    <message>
        <source>no material has a specular share</source>
        <translation>kein Material glänzt</translation>
    </message>
    <message>
        <source>measured photometry</source>
        <translation>gemessene Lichtverteilungen</translation>
    </message>
    <message>
        <source>no luminaire names a file</source>
        <translation>keine Leuchte nennt eine Datei</translation>
    </message>
    <message>
        <source>luminaires as obstacles</source>
        <translation>Leuchten als Hindernisse</translation>
    </message>
    <message>
        <source>no luminaire casts a shadow</source>
        <translation>keine Leuchte wirft Schatten</translation>
    </message>
    <message>
        <source>light from outside</source>
        <translation>Licht von außen</translation>
    </message>
    <message>
        <source>the project has no environment</source>
        <translation>das Projekt hat keine Umgebung</translation>
    </message>
    <message>
        <source>sunlight</source>
        <translation>Sonnenlicht</translation>
    </message>
    <message>
        <source>the environment has no sun</source>
        <translation>die Umgebung hat keine Sonne</translation>
    </message>
    <message>
        <source>light through glass</source>
        <translation>Licht durch Glas</translation>
    </message>
    <message>
        <source>no material is glass</source>
        <translation>kein Material ist Glas</translation>
    </message>
    <message>
        <source>light of smooth skies</source>
        <translation>Licht glatter Himmel</translation>
    </message>
    <message>
        <source>tracing paths</source>
        <translation>Pfade verfolgen</translation>
    </message>
    <message>
        <source>last bounce</source>
        <translation>letzte Reflexion</translation>
    </message>
    <message>
        <source>making receivers</source>
        <translation>Empfangspunkte setzen</translation>
    </message>
    <message>
        <source>shadows for direct light</source>
        <translation>Schatten für direktes Licht</translation>
    </message>
    <message>
        <source>shadow pass</source>
        <translation>Schattendurchgang</translation>
    </message>
    <message>
        <source>following reflections</source>
        <translation>Reflexe werden verfolgt</translation>
    </message>
    <message>
        <source>pictures on surfaces</source>
        <translation>Bilder auf Flächen</translation>
    </message>
    <message>
        <source>no material has a diffuse map</source>
        <translation>kein Material hat ein Farbbild</translation>
    </message>
    <message>
        <source>bent normals</source>
        <translation>geneigte Normalen</translation>
    </message>
    <message>
        <source>no material has a normal map</source>
        <translation>kein Material hat ein Normalenbild</translation>
    </message>
    <message>
        <source>roughness that changes</source>
        <translation>wechselnde Rauheit</translation>
    </message>
    <message>
        <source>no material has a roughness map</source>
        <translation>kein Material hat ein Rauheitsbild</translation>
    </message>
</context>
<context>
    <name>DragSession</name>
    <message>
        <source>Copy to %1</source>
        <translation>Kopieren als %1</translation>
    </message>
    <message numerus="yes">
        <source>Copy %n luminaires</source>
        <translation>
            <numerusform>%n Leuchte kopieren</numerusform>
            <numerusform>%n Leuchten kopieren</numerusform>
        </translation>
    </message>
    <message>
        <source>Rotate %1</source>
        <translation>%1 drehen</translation>
    </message>
    <message numerus="yes">
        <source>Rotate %n luminaires</source>
        <translation>
            <numerusform>%n Leuchte drehen</numerusform>
            <numerusform>%n Leuchten drehen</numerusform>
        </translation>
    </message>
    <message>
        <source>Resize %1</source>
        <translation>Größe von %1 ändern</translation>
    </message>
    <message numerus="yes">
        <source>Resize %n luminaires</source>
        <translation>
            <numerusform>Größe von %n Leuchte ändern</numerusform>
            <numerusform>Größe von %n Leuchten ändern</numerusform>
        </translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 verschieben</translation>
    </message>
    <message numerus="yes">
        <source>Move %n luminaires</source>
        <translation>
            <numerusform>%n Leuchte verschieben</numerusform>
            <numerusform>%n Leuchten verschieben</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>LightMarks</name>
    <message>
        <source>Probe %1</source>
        <translation>Messpunkt %1</translation>
    </message>
</context>
<context>
    <name>soffit::ui</name>
    <message>
        <source>The project was not saved</source>
        <translation>Das Projekt wurde nicht gespeichert</translation>
    </message>
    <message>
        <source>Open a project</source>
        <translation>Projekt öffnen</translation>
    </message>
    <message>
        <source>Soffit projects (*.soffit);;All files (*)</source>
        <translation>Soffit-Projekte (*.soffit);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Import a model</source>
        <translation>Modell importieren</translation>
    </message>
    <message>
        <source>Models (*.obj *.gltf *.glb *.ply *.stl *.3ds *.fbx *.dae *.ifc);;All files (*)</source>
        <translation>Modelle (*.obj *.gltf *.glb *.ply *.stl *.3ds *.fbx *.dae *.ifc);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save the project as</source>
        <translation>Projekt speichern unter</translation>
    </message>
    <message>
        <source>Soffit projects (*.soffit)</source>
        <translation>Soffit-Projekte (*.soffit)</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>Änderungen an „%1“ speichern?</translation>
    </message>
    <message>
        <source>Without saving they are lost.</source>
        <translation>Ohne Speichern gehen sie verloren.</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Switch on</source>
        <translation>Einschalten</translation>
    </message>
    <message>
        <source>Switch off</source>
        <translation>Ausschalten</translation>
    </message>
    <message>
        <source>Dim</source>
        <translation>Dimmen</translation>
    </message>
    <message>
        <source>Export the readings</source>
        <translation>Ergebnisse exportieren</translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>Durch Kommas getrennte Werte (*.csv)</translation>
    </message>
    <message>
        <source>The readings were not written</source>
        <translation>Die Ergebnisse wurden nicht geschrieben</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>Ringleuchte</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Panel</translation>
    </message>
    <message>
        <source>Panel long</source>
        <translation>Langpanel</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Lichtlinie</translation>
    </message>
    <message>
        <source>Linear suspended</source>
        <translation>Lichtlinie abgehängt</translation>
    </message>
    <message>
        <source>Pendant</source>
        <translation>Pendelleuchte</translation>
    </message>
    <message>
        <source>Downlight</source>
        <translation>Downlight</translation>
    </message>
    <message>
        <source>70°</source>
        <translation>70°</translation>
    </message>
    <message>
        <source>Spot</source>
        <translation>Spot</translation>
    </message>
    <message>
        <source>24°</source>
        <translation>24°</translation>
    </message>
    <message>
        <source>Track spot</source>
        <translation>Stromschienenstrahler</translation>
    </message>
    <message>
        <source>36°, on a track</source>
        <translation>36°, Schiene</translation>
    </message>
    <message>
        <source>Wall washer</source>
        <translation>Wandfluter</translation>
    </message>
    <message>
        <source>lights one side</source>
        <translation>asymmetrisch</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>see Properties</source>
        <translation>siehe Eigenschaften</translation>
    </message>
    <message>
        <source>no group</source>
        <translation>ohne Gruppe</translation>
    </message>
    <message>
        <source>Dim %1</source>
        <translation>%1 dimmen</translation>
    </message>
    <message>
        <source>Switch on %1</source>
        <translation>%1 einschalten</translation>
    </message>
    <message>
        <source>Switch off %1</source>
        <translation>%1 ausschalten</translation>
    </message>
    <message>
        <source>Colour %1</source>
        <translation>Lichtfarbe von %1 ändern</translation>
    </message>
    <message>
        <source>Light scene %1</source>
        <translation>Lichtszene %1</translation>
    </message>
    <message>
        <source>Scene %1</source>
        <translation>Szene %1</translation>
    </message>
    <message>
        <source>Store light scene</source>
        <translation>Lichtszene speichern</translation>
    </message>
    <message>
        <source>Rename light scene</source>
        <translation>Lichtszene umbenennen</translation>
    </message>
    <message>
        <source>Delete light scene</source>
        <translation>Lichtszene löschen</translation>
    </message>
    <message>
        <source>As it was opened</source>
        <translation>Wie geöffnet</translation>
    </message>
    <message>
        <source>A click goes back or forward to that step</source>
        <translation>Ein Klick führt zu diesem Schritt zurück oder vor</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Eigenschaften</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Light mixer</source>
        <translation>Lichtmischer</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>Materialien</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothek</translation>
    </message>
    <message>
        <source>Layouts</source>
        <translation>Varianten</translation>
    </message>
    <message>
        <source>Light list</source>
        <translation>Leuchtenliste</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Lambertian</source>
        <translation>Lambertsch</translation>
    </message>
    <message>
        <source>Isotropic</source>
        <translation>Isotrop</translation>
    </message>
    <message>
        <source>RGB</source>
        <translation>RGB</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspektive</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Grundriss</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorderansicht</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Rückansicht</translation>
    </message>
    <message>
        <source>Left side</source>
        <translation>Linke Seite</translation>
    </message>
    <message>
        <source>Right side</source>
        <translation>Rechte Seite</translation>
    </message>
    <message>
        <source>Section from the front</source>
        <translation>Schnitt von vorn</translation>
    </message>
    <message>
        <source>Section from the back</source>
        <translation>Schnitt von hinten</translation>
    </message>
    <message>
        <source>Section from the left</source>
        <translation>Schnitt von links</translation>
    </message>
    <message>
        <source>Section from the right</source>
        <translation>Schnitt von rechts</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Ansicht %1</translation>
    </message>
    <message>
        <source>Save camera %1</source>
        <translation>Kamera %1 speichern</translation>
    </message>
    <message>
        <source>Update camera %1</source>
        <translation>Kamera %1 aktualisieren</translation>
    </message>
    <message>
        <source>Rename camera %1</source>
        <translation>Kamera %1 umbenennen</translation>
    </message>
    <message>
        <source>Delete camera %1</source>
        <translation>Kamera %1 löschen</translation>
    </message>
    <message>
        <source>Reorder cameras</source>
        <translation>Kameras umordnen</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Probes</source>
        <translation>Messpunkte</translation>
    </message>
    <message>
        <source>Pictures on this machine are at most %1 × %2 pixels</source>
        <translation>Bilder sind auf diesem Rechner höchstens %1 × %2 Pixel groß</translation>
    </message>
    <message>
        <source>Choose a smaller size.</source>
        <translation>Wählen Sie eine kleinere Größe.</translation>
    </message>
    <message>
        <source>The graphics driver gives no second OpenGL context</source>
        <translation>Der Grafiktreiber gibt keinen zweiten OpenGL-Kontext her</translation>
    </message>
    <message>
        <source>Take the picture with “soffit render”, or as a screenshot.</source>
        <translation>Nehmen Sie das Bild mit „soffit render“ auf, oder als Bildschirmfoto.</translation>
    </message>
    <message>
        <source>There is not enough memory for a picture of this size</source>
        <translation>Der Speicher reicht nicht für ein Bild dieser Größe</translation>
    </message>
    <message>
        <source>Overcast, steep gradation</source>
        <translation>Bedeckt, steiler Helligkeitsverlauf</translation>
    </message>
    <message>
        <source>Overcast, steep, brighter toward the sun</source>
        <translation>Bedeckt, steil, zur Sonne hin heller</translation>
    </message>
    <message>
        <source>Overcast, moderate gradation</source>
        <translation>Bedeckt, mäßiger Helligkeitsverlauf</translation>
    </message>
    <message>
        <source>Overcast, moderate, brighter toward the sun</source>
        <translation>Bedeckt, mäßig, zur Sonne hin heller</translation>
    </message>
    <message>
        <source>Uniform</source>
        <translation>Gleichmäßig</translation>
    </message>
    <message>
        <source>Partly cloudy, slightly brighter toward the sun</source>
        <translation>Teils bewölkt, zur Sonne hin etwas heller</translation>
    </message>
    <message>
        <source>Partly cloudy, bright around the sun</source>
        <translation>Teils bewölkt, um die Sonne hell</translation>
    </message>
    <message>
        <source>Partly cloudy, distinct corona</source>
        <translation>Teils bewölkt, deutliche Korona</translation>
    </message>
    <message>
        <source>Partly cloudy, sun obscured</source>
        <translation>Teils bewölkt, Sonne verdeckt</translation>
    </message>
    <message>
        <source>Partly cloudy, bright around the sun, darker zenith</source>
        <translation>Teils bewölkt, um die Sonne hell, Zenit dunkler</translation>
    </message>
    <message>
        <source>White-blue, distinct corona</source>
        <translation>Weißblau, deutliche Korona</translation>
    </message>
    <message>
        <source>Clear, low turbidity</source>
        <translation>Klar, geringe Trübung</translation>
    </message>
    <message>
        <source>Clear, polluted air</source>
        <translation>Klar, verunreinigte Luft</translation>
    </message>
    <message>
        <source>Cloudless, turbid, broad corona</source>
        <translation>Wolkenlos, trüb, breite Korona</translation>
    </message>
    <message>
        <source>White-blue, turbid, broad corona</source>
        <translation>Weißblau, trüb, breite Korona</translation>
    </message>
    <message>
        <source>Traditional overcast (1 : 3)</source>
        <translation>Herkömmlich bedeckt (1 : 3)</translation>
    </message>
    <message>
        <source>Daylight</source>
        <translation>Tageslicht</translation>
    </message>
    <message>
        <source>⌀ %1, suspended</source>
        <translation>⌀ %1, Pendel</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>%1, on the ceiling</source>
        <translation>%1, Anbau</translation>
    </message>
    <message>
        <source>%1, suspended</source>
        <translation>%1, Pendel</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Where light is computed and sent on</source>
        <translation>Wo Licht berechnet und weitergegeben wird</translation>
    </message>
    <message>
        <source>Least distance of points, m</source>
        <translation>Kleinster Punktabstand, m</translation>
    </message>
    <message>
        <source>Greatest distance of points, m</source>
        <translation>Größter Punktabstand, m</translation>
    </message>
    <message>
        <source>Large buildings get up to four times as many points for it</source>
        <translation>Große Gebäude erhalten dafür bis zu viermal so viele Punkte</translation>
    </message>
    <message>
        <source>Points per patch</source>
        <translation>Punkte je Fläche</translation>
    </message>
    <message>
        <source>Further reflections go from patch to patch</source>
        <translation>Weitere Reflexionen gehen von Fläche zu Fläche</translation>
    </message>
    <message>
        <source>Rays per point between patches, squared</source>
        <translation>Strahlen je Punkt zwischen Flächen, zum Quadrat</translation>
    </message>
    <message>
        <source>Training lights</source>
        <translation>Übungsleuchten</translation>
    </message>
    <message>
        <source>From them the program learns where light differs</source>
        <translation>An ihnen lernt das Programm, wo sich Licht unterscheidet</translation>
    </message>
    <message>
        <source>Rays per point and training, squared</source>
        <translation>Strahlen je Punkt und Übung, zum Quadrat</translation>
    </message>
    <message>
        <source>Rays per gather point, squared</source>
        <translation>Strahlen je Sammelpunkt, zum Quadrat</translation>
    </message>
    <message>
        <source>Noise of the first reflection</source>
        <translation>Rauschen der ersten Reflexion</translation>
    </message>
    <message>
        <source>Gather points per group, at most</source>
        <translation>Sammelpunkte je Gruppe, höchstens</translation>
    </message>
    <message>
        <source>Gather points per point, at most</source>
        <translation>Sammelpunkte je Punkt, höchstens</translation>
    </message>
    <message>
        <source>What a gather point must tell</source>
        <translation>Was ein Sammelpunkt beitragen muss</translation>
    </message>
    <message>
        <source>One that tells less than this share of the mean is left out</source>
        <translation>Wer weniger als diesen Anteil des Mittels beiträgt, entfällt</translation>
    </message>
    <message>
        <source>Rays per calculation point, squared</source>
        <translation>Strahlen je Berechnungspunkt, zum Quadrat</translation>
    </message>
    <message>
        <source>Noise of values on work planes</source>
        <translation>Rauschen der Werte auf Nutzebenen</translation>
    </message>
    <message>
        <source>Bands of harmonics</source>
        <translation>Bänder der Kugelfunktionen</translation>
    </message>
    <message>
        <source>Sharper shadows and more ringing with more</source>
        <translation>Mehr: schärfere Schatten, mehr Überschwingen</translation>
    </message>
    <message>
        <source>Directions of shadows</source>
        <translation>Richtungen der Schatten</translation>
    </message>
    <message>
        <source>Rays per point, harmonics alone</source>
        <translation>Strahlen je Punkt, nur Kugelfunktionen</translation>
    </message>
    <message>
        <source>Reach of shadows, m</source>
        <translation>Reichweite der Schatten, m</translation>
    </message>
    <message>
        <source>What lies farther from a point does not shade it, harmonics alone</source>
        <translation>Was weiter von einem Punkt entfernt ist, verschattet ihn nicht; nur Kugelfunktionen</translation>
    </message>
    <message>
        <source>Texels along a cube&apos;s edge</source>
        <translation>Texel je Würfelkante</translation>
    </message>
    <message>
        <source>Cube maps alone</source>
        <translation>Nur Würfelbilder</translation>
    </message>
    <message>
        <source>Reflections from point to point</source>
        <translation>Reflexionen von Punkt zu Punkt</translation>
    </message>
    <message>
        <source>Once more between all points, for what patches are too coarse for</source>
        <translation>Noch einmal zwischen allen Punkten, wofür Flächenstücke zu grob sind</translation>
    </message>
</context>
<context>
    <name>soffit::ui::AboutDialog</name>
    <message>
        <source>About Soffit</source>
        <translation>Über Soffit</translation>
    </message>
    <message>
        <source>Interactive, converged light for indoor architecture</source>
        <translation>Interaktives, auskonvergiertes Licht für Innenräume</translation>
    </message>
    <message>
        <source>Built with %1 for Qt %2</source>
        <translation>Gebaut mit %1 für Qt %2</translation>
    </message>
    <message>
        <source>Running on %1, %2</source>
        <translation>Läuft unter %1, %2</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothek</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>Licence</source>
        <translation>Lizenz</translation>
    </message>
    <message>
        <source>The libraries are those of the system; the texts of their licences lie there, in Debian in /usr/share/doc.</source>
        <translation>Die Bibliotheken sind die des Systems; die Texte ihrer Lizenzen liegen dort, unter Debian in /usr/share/doc.</translation>
    </message>
    <message>
        <source>&amp;Versions</source>
        <translation>&amp;Versionen</translation>
    </message>
    <message>
        <source>&amp;Licence of Soffit</source>
        <translation>&amp;Lizenz von Soffit</translation>
    </message>
    <message>
        <source>&amp;Copy the versions</source>
        <translation>Versionen &amp;kopieren</translation>
    </message>
</context>
<context>
    <name>soffit::ui::AdvancedQuality</name>
    <message>
        <source>Harmonics times transfer</source>
        <translation>Kugelfunktionen mal Transfer</translation>
    </message>
    <message>
        <source>Dynamic cube maps</source>
        <translation>Bewegte Würfelbilder</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Exakt</translation>
    </message>
    <message>
        <source>Advanced quality</source>
        <translation>Qualität im Einzelnen</translation>
    </message>
    <message>
        <source>How the direct light of luminaires is computed in the view. The exact method is faster and nearer to the truth; the others are those of the founding papers, to compare.</source>
        <translation>Wie das direkte Licht der Leuchten in der Ansicht berechnet wird. Das exakte Verfahren ist schneller und näher an der Wahrheit; die anderen sind die der Grundlagenarbeiten, zum Vergleich.</translation>
    </message>
    <message>
        <source>Direct light</source>
        <translation>Direktes Licht</translation>
    </message>
    <message>
        <source>%1 to %2, preset %3</source>
        <translation>%1 bis %2, Vorgabe %3</translation>
    </message>
    <message>
        <source>Changes are precomputed in the background. What differs from the preset is bold.</source>
        <translation>Änderungen werden im Hintergrund vorberechnet. Was von der Vorgabe abweicht, ist fett.</translation>
    </message>
</context>
<context>
    <name>soffit::ui::Aiming</name>
    <message>
        <source>Aim</source>
        <translation>Ausrichten</translation>
    </message>
    <message>
        <source>Click the point to aim at. Shift: aim again. Esc: done.</source>
        <translation>Auf den Zielpunkt klicken. Umschalt: erneut ausrichten. Esc: fertig.</translation>
    </message>
</context>
<context>
    <name>soffit::ui::ArrayBar</name>
    <message>
        <source>Line along x</source>
        <translation>Linie x</translation>
    </message>
    <message>
        <source>Line along y</source>
        <translation>Linie y</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>Luminaires along x</source>
        <translation>Leuchten entlang x</translation>
    </message>
    <message>
        <source>Luminaires along y</source>
        <translation>Leuchten entlang y</translation>
    </message>
    <message>
        <source>Spacing along x; 0: the walls half a spacing away</source>
        <translation>Abstand entlang x; 0: zu den Wänden ein halber Abstand</translation>
    </message>
    <message>
        <source>Spacing along y; 0: the walls half a spacing away</source>
        <translation>Abstand entlang y; 0: zu den Wänden ein halber Abstand</translation>
    </message>
    <message>
        <source>Radius of the circle</source>
        <translation>Radius des Kreises</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>to the walls %1</source>
        <translation>Wand %1</translation>
    </message>
</context>
<context>
    <name>soffit::ui::Arraying</name>
    <message numerus="yes">
        <source>Array of %n luminaires</source>
        <translation>
            <numerusform>Anordnung aus %n Leuchte</numerusform>
            <numerusform>Anordnung aus %n Leuchten</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag squares for the spacing, disks for the count. Enter: apply. Esc: give up.</source>
        <translation>Quadrate ziehen: Abstand; Scheiben ziehen: Anzahl. Eingabe: anwenden. Esc: verwerfen.</translation>
    </message>
</context>
<context>
    <name>soffit::ui::CameraControl</name>
    <message>
        <source>Walking at %L1 m/s: W A S D, Q down, E up, Shift faster, wheel: speed</source>
        <translation>Gehen mit %L1 m/s: W A S D, Q abwärts, E aufwärts, Umschalt schneller, Rad: Tempo</translation>
    </message>
</context>
<context>
    <name>soffit::ui::CamerasPanel</name>
    <message>
        <source>Saved cameras</source>
        <translation>Gespeicherte Kameras</translation>
    </message>
    <message>
        <source>A click looks from there; double-click or F2: another name; drag: order</source>
        <translation>Ein Klick blickt von dort; Doppelklick oder F2: anderer Name; Ziehen: Reihenfolge</translation>
    </message>
    <message>
        <source>Save view</source>
        <translation>Ansicht speichern</translation>
    </message>
    <message>
        <source>Saves what the active view shows as a camera of the project</source>
        <translation>Speichert, was die aktive Ansicht zeigt, als Kamera des Projekts</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>Aktualisieren</translation>
    </message>
    <message>
        <source>The selected camera takes what the active view shows</source>
        <translation>Die ausgewählte Kamera übernimmt, was die aktive Ansicht zeigt</translation>
    </message>
    <message>
        <source>Further up</source>
        <translation>Weiter nach oben</translation>
    </message>
    <message>
        <source>Further down</source>
        <translation>Weiter nach unten</translation>
    </message>
    <message>
        <source>Delete the selected camera</source>
        <translation>Die ausgewählte Kamera löschen</translation>
    </message>
</context>
<context>
    <name>soffit::ui::CommandPalette</name>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>Name of a command</source>
        <translation>Name eines Befehls</translation>
    </message>
</context>
<context>
    <name>soffit::ui::ComparisonBar</name>
    <message>
        <source>Base</source>
        <translation>Basis</translation>
    </message>
    <message>
        <source>Swap: edit the other layout</source>
        <translation>Tauschen: die andere Variante bearbeiten</translation>
    </message>
    <message>
        <source>Swap the layouts</source>
        <translation>Varianten tauschen</translation>
    </message>
    <message>
        <source>Layout to compare with</source>
        <translation>Variante, mit der verglichen wird</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Geteilt</translation>
    </message>
    <message>
        <source>A slider between the two</source>
        <translation>Ein Schieber zwischen beiden</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Beide</translation>
    </message>
    <message>
        <source>Two pictures, one camera</source>
        <translation>Zwei Bilder, eine Kamera</translation>
    </message>
    <message>
        <source>Blink</source>
        <translation>Blinken</translation>
    </message>
    <message>
        <source>One after the other (B)</source>
        <translation>Eine nach der anderen (B)</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>Illuminance of the second minus that of the first, in lux</source>
        <translation>Beleuchtungsstärke der zweiten minus die der ersten, in Lux</translation>
    </message>
    <message>
        <source>Ends of the scale</source>
        <translation>Enden der Skala</translation>
    </message>
    <message>
        <source>End the comparison (Shift+B)</source>
        <translation>Vergleich beenden (Umschalt+B)</translation>
    </message>
    <message>
        <source>End the comparison</source>
        <translation>Vergleich beenden</translation>
    </message>
</context>
<context>
    <name>soffit::ui::ComparisonSession</name>
    <message>
        <source>Base</source>
        <translation>Basis</translation>
    </message>
</context>
<context>
    <name>soffit::ui::ComparisonView</name>
    <message>
        <source>Split between the layouts</source>
        <translation>Teilung zwischen den Varianten</translation>
    </message>
    <message>
        <source>%1 − %2</source>
        <translation>%1 − %2</translation>
    </message>
</context>
<context>
    <name>soffit::ui::DaylightPanel</name>
    <message>
        <source>None</source>
        <translation>Keines</translation>
    </message>
    <message>
        <source>Standard sky (CIE)</source>
        <translation>Normhimmel (CIE)</translation>
    </message>
    <message>
        <source>Light probe (picture)</source>
        <translation>Lichtsonde (Bild)</translation>
    </message>
    <message>
        <source>Analytic light</source>
        <translation>Formellicht</translation>
    </message>
    <message>
        <source>What shines in through openings and glass; the same in all layouts</source>
        <translation>Was durch Öffnungen und Glas hereinscheint; in allen Varianten dasselbe</translation>
    </message>
    <message>
        <source>Outside</source>
        <translation>Außen</translation>
    </message>
    <message>
        <source>Standard skies of ISO 15469 (CIE S 011), and the traditional overcast one</source>
        <translation>Normhimmel der ISO 15469 (CIE S 011) und der herkömmliche bedeckte</translation>
    </message>
    <message>
        <source>From north (+y) clockwise seen from above: 90° is east (+x)</source>
        <translation>Von Norden (+y) im Uhrzeigersinn von oben gesehen: 90° ist Osten (+x)</translation>
    </message>
    <message>
        <source>Above the horizon</source>
        <translation>Über dem Horizont</translation>
    </message>
    <message>
        <source>Of the sky alone on an open horizontal plane, without the sun</source>
        <translation>Des Himmels allein auf einer freien waagrechten Ebene, ohne die Sonne</translation>
    </message>
    <message>
        <source>Of the sun alone on a plane that faces it; 0: no sun</source>
        <translation>Der Sonne allein auf einer Ebene, die ihr zugewandt ist; 0: keine Sonne</translation>
    </message>
    <message>
        <source>Of the ground around the building, which mirrors the sky&apos;s light evenly</source>
        <translation>Des Bodens um das Gebäude, der das Himmelslicht gleichmäßig zurückwirft</translation>
    </message>
    <message>
        <source>Sky</source>
        <translation>Himmel</translation>
    </message>
    <message>
        <source>Sun azimuth</source>
        <translation>Sonnenazimut</translation>
    </message>
    <message>
        <source>Sun altitude</source>
        <translation>Sonnenhöhe</translation>
    </message>
    <message>
        <source>Sky light</source>
        <translation>Himmelslicht</translation>
    </message>
    <message>
        <source>Sunlight</source>
        <translation>Sonnenlicht</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Sky type</source>
        <translation>Art des Himmels</translation>
    </message>
    <message>
        <source>Ground reflectance</source>
        <translation>Reflexionsgrad des Bodens</translation>
    </message>
    <message>
        <source>An HDR or EXR picture of the surroundings, all round</source>
        <translation>Ein HDR- oder EXR-Bild der Umgebung ringsum</translation>
    </message>
    <message>
        <source>Latitude and longitude</source>
        <translation>Länge und Breite</translation>
    </message>
    <message>
        <source>Angular map (mirror ball)</source>
        <translation>Winkelkarte (Spiegelkugel)</translation>
    </message>
    <message>
        <source>Cross</source>
        <translation>Kreuz</translation>
    </message>
    <message>
        <source>How the picture is laid out; its centre looks to +y</source>
        <translation>Wie das Bild aufgeteilt ist; seine Mitte blickt nach +y</translation>
    </message>
    <message>
        <source>Counter-clockwise seen from above</source>
        <translation>Gegen den Uhrzeigersinn, von oben gesehen</translation>
    </message>
    <message>
        <source>Luminance of a pixel of value 1, cd/m²</source>
        <translation>Leuchtdichte eines Pixels vom Wert 1, cd/m²</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Aufteilung</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Layout of the light probe</source>
        <translation>Aufteilung der Lichtsonde</translation>
    </message>
    <message>
        <source>Turn the surroundings</source>
        <translation>Umgebung drehen</translation>
    </message>
    <message>
        <source>Scale of the light probe</source>
        <translation>Maßstab der Lichtsonde</translation>
    </message>
    <message>
        <source>Luminance of the formula&apos;s value 1, cd/m²</source>
        <translation>Leuchtdichte des Formelwerts 1, cd/m²</translation>
    </message>
    <message>
        <source>Overhead gain</source>
        <translation>Verstärkung oben</translation>
    </message>
    <message>
        <source>max(0, gain · cos θ − threshold): the patch overhead</source>
        <translation>max(0, Verstärkung · cos θ − Schwelle): der Fleck oben</translation>
    </message>
    <message>
        <source>Overhead threshold</source>
        <translation>Schwelle oben</translation>
    </message>
    <message>
        <source>Side gain</source>
        <translation>Verstärkung Seite</translation>
    </message>
    <message>
        <source>The patch at the horizon</source>
        <translation>Der Fleck am Horizont</translation>
    </message>
    <message>
        <source>Side threshold</source>
        <translation>Schwelle Seite</translation>
    </message>
    <message>
        <source>Light from outside</source>
        <translation>Licht von außen</translation>
    </message>
    <message>
        <source>Light probe</source>
        <translation>Lichtsonde</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Bilder (%1)</translation>
    </message>
    <message>
        <source>Reading the picture…</source>
        <translation>Das Bild wird gelesen…</translation>
    </message>
    <message>
        <source>Nothing shines in. Windows need an opening or a material that is glass (see Materials).</source>
        <translation>Nichts scheint herein. Fenster brauchen eine Öffnung oder ein Material aus Glas (siehe Materialien).</translation>
    </message>
</context>
<context>
    <name>soffit::ui::DifferenceModel</name>
    <message>
        <source>U₀</source>
        <translation>U₀</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Φ lm</source>
        <translation>Φ lm</translation>
    </message>
    <message>
        <source>lm/m²</source>
        <translation>lm/m²</translation>
    </message>
    <message>
        <source>P W</source>
        <translation>P W</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Basis</translation>
    </message>
    <message>
        <source>Work plane</source>
        <translation>Nutzebene</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>First</source>
        <translation>Erste</translation>
    </message>
    <message>
        <source>Second</source>
        <translation>Zweite</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>Ēm</source>
        <translation>Ēm</translation>
    </message>
    <message>
        <source>Emin</source>
        <translation>Emin</translation>
    </message>
    <message>
        <source>Emax</source>
        <translation>Emax</translation>
    </message>
</context>
<context>
    <name>soffit::ui::DrawingPolygon</name>
    <message>
        <source>first corner</source>
        <translation>erste Ecke</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Polygon</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>The outline crosses itself: take corners back with Backspace.</source>
        <translation>Der Umriss schneidet sich selbst: Ecken mit der Rücktaste zurücknehmen.</translation>
    </message>
    <message>
        <source>Click the corners of the luminaire on the ceiling. Ctrl: grid. Esc: give up.</source>
        <translation>Die Ecken der Leuchte auf der Decke anklicken. Strg: Raster. Esc: verwerfen.</translation>
    </message>
    <message>
        <source>Next corner; Enter or the first corner closes the outline. Backspace: take one back.</source>
        <translation>Nächste Ecke; Eingabe oder die erste Ecke schließt den Umriss. Rücktaste: eine zurücknehmen.</translation>
    </message>
</context>
<context>
    <name>soffit::ui::DrawingProfile</name>
    <message>
        <source>Click the end of the line. Esc: done.</source>
        <translation>Ende der Linie anklicken. Esc: fertig.</translation>
    </message>
    <message>
        <source>Click the start of the line on a surface. Esc: done.</source>
        <translation>Anfang der Linie auf einer Fläche anklicken. Esc: fertig.</translation>
    </message>
</context>
<context>
    <name>soffit::ui::ErrorMap</name>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Errors against the reference</source>
        <translation>Fehler gegenüber der Referenz</translation>
    </message>
</context>
<context>
    <name>soffit::ui::EvaluationChoice</name>
    <message>
        <source>GPU</source>
        <translation>GPU</translation>
    </message>
    <message>
        <source>CPU</source>
        <translation>CPU</translation>
    </message>
    <message>
        <source>Light in the views is evaluated by the processor, as chosen in the View menu.</source>
        <translation>Das Licht in den Ansichten wird vom Prozessor ausgewertet, wie im Menü Ansicht gewählt.</translation>
    </message>
    <message>
        <source>Light in the views is evaluated by the processor: %1.</source>
        <translation>Das Licht in den Ansichten wird vom Prozessor ausgewertet: %1.</translation>
    </message>
    <message>
        <source>Light in the views is evaluated by shaders on %1, as chosen in the View menu.</source>
        <translation>Das Licht in den Ansichten wird von Shadern auf %1 ausgewertet, wie im Menü Ansicht gewählt.</translation>
    </message>
    <message>
        <source>Light in the views is evaluated by the processor: there is no graphics processor, pictures are drawn by a program (%1).</source>
        <translation>Das Licht in den Ansichten wird vom Prozessor ausgewertet: Es gibt keinen Grafikprozessor, Bilder zeichnet ein Programm (%1).</translation>
    </message>
    <message>
        <source>Light in the views is evaluated by shaders on the graphics processor (%1).</source>
        <translation>Das Licht in den Ansichten wird von Shadern auf dem Grafikprozessor ausgewertet (%1).</translation>
    </message>
</context>
<context>
    <name>soffit::ui::FinishFields</name>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Schlüsselwert</translation>
    </message>
    <message>
        <source>What the average of the picture becomes; 0.18 is mid grey</source>
        <translation>Was aus dem Mittel des Bildes wird; 0,18 ist mittleres Grau</translation>
    </message>
    <message>
        <source>White point</source>
        <translation>Weißpunkt</translation>
    </message>
    <message>
        <source>The smallest brightness that becomes white, where the average is the key</source>
        <translation>Die kleinste Helligkeit, die weiß wird, wenn das Mittel der Schlüsselwert ist</translation>
    </message>
    <message>
        <source>Bloom above</source>
        <translation>Überstrahlung ab</translation>
    </message>
    <message>
        <source>Spreads light about what is brighter, in pictures alone</source>
        <translation>Verteilt Licht um das, was heller ist; nur in Bildern</translation>
    </message>
    <message>
        <source>Luminance above which light is spread</source>
        <translation>Leuchtdichte, ab der Licht verteilt wird</translation>
    </message>
    <message>
        <source>Share of the light that is spread</source>
        <translation>Anteil des Lichts, der verteilt wird</translation>
    </message>
    <message>
        <source>Key of the picture</source>
        <translation>Schlüsselwert des Bildes</translation>
    </message>
    <message>
        <source>Bloom</source>
        <translation>Überstrahlung</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
</context>
<context>
    <name>soffit::ui::GroupStrip</name>
    <message>
        <source>On</source>
        <translation>Ein</translation>
    </message>
    <message>
        <source>Switch the group</source>
        <translation>Gruppe schalten</translation>
    </message>
    <message>
        <source>Solo</source>
        <translation>Solo</translation>
    </message>
    <message>
        <source>Only this group, to look at it; others go dark until then</source>
        <translation>Nur diese Gruppe ansehen; die anderen sind solange dunkel</translation>
    </message>
    <message>
        <source>Select its luminaires</source>
        <translation>Ihre Leuchten auswählen</translation>
    </message>
    <message>
        <source>Dimming</source>
        <translation>Dimmwert</translation>
    </message>
    <message>
        <source>Dimming of the group; where its luminaires differ, of the brightest</source>
        <translation>Dimmwert der Gruppe; weichen ihre Leuchten ab, der hellsten</translation>
    </message>
    <message>
        <source>Correlated colour temperature</source>
        <translation>Ähnlichste Farbtemperatur</translation>
    </message>
    <message>
        <source>Coloured light…</source>
        <translation>Farbiges Licht…</translation>
    </message>
    <message>
        <source>Coloured light</source>
        <translation>Farbiges Licht</translation>
    </message>
    <message>
        <source>No group</source>
        <translation>Ohne Gruppe</translation>
    </message>
    <message>
        <source>Some</source>
        <translation>Teils</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>RGB</source>
        <translation>RGB</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>gemischt</translation>
    </message>
</context>
<context>
    <name>soffit::ui::HelpWindow</name>
    <message>
        <source>Previous hit</source>
        <translation>Vorige Fundstelle</translation>
    </message>
    <message>
        <source>Next hit</source>
        <translation>Nächste Fundstelle</translation>
    </message>
    <message>
        <source>Help for Soffit</source>
        <translation>Hilfe zu Soffit</translation>
    </message>
    <message>
        <source>Search all pages</source>
        <translation>Alle Seiten durchsuchen</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vor</translation>
    </message>
    <message>
        <source>The pages of the help were not found in %1.</source>
        <translation>Die Seiten der Hilfe wurden in %1 nicht gefunden.</translation>
    </message>
    <message>
        <source>On no page</source>
        <translation>Auf keiner Seite</translation>
    </message>
    <message numerus="yes">
        <source>On %n page(s)</source>
        <translation>
            <numerusform>Auf %n Seite</numerusform>
            <numerusform>Auf %n Seiten</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>soffit::ui::ImportSheet</name>
    <message>
        <source>A new project</source>
        <translation>Ein neues Projekt</translation>
    </message>
    <message>
        <source>The open project, %1</source>
        <translation>Das geöffnete Projekt, %1</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>%1 importieren</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>What one unit of the file is; files that state their unit are in metres already</source>
        <translation>Was eine Einheit der Datei bedeutet; Dateien, die ihre Einheit angeben, liegen bereits in Metern vor</translation>
    </message>
    <message>
        <source>As the file says</source>
        <translation>Wie in der Datei angegeben</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>Achse nach oben</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Auswählen…</translation>
    </message>
    <message>
        <source>Into</source>
        <translation>In</translation>
    </message>
    <message>
        <source>Reading the model…</source>
        <translation>Modell wird gelesen…</translation>
    </message>
    <message>
        <source>Unusual for a building: is the unit right?</source>
        <translation>Ungewöhnlich für ein Gebäude: Stimmt die Einheit?</translation>
    </message>
    <message>
        <source>The new project</source>
        <translation>Das neue Projekt</translation>
    </message>
    <message>
        <source>Soffit projects (*.soffit)</source>
        <translation>Soffit-Projekte (*.soffit)</translation>
    </message>
    <message>
        <source>%L1 triangles, %L2 materials, %3 × %4 m in plan, %5 m high</source>
        <translation>%L1 Dreiecke, %L2 Materialien, %3 × %4 m im Grundriss, %5 m hoch</translation>
    </message>
</context>
<context>
    <name>soffit::ui::KeysDialog</name>
    <message>
        <source>&amp;Assign</source>
        <translation>&amp;Zuweisen</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>Zu&amp;rücksetzen</translation>
    </message>
    <message>
        <source>Mouse and keys</source>
        <translation>Maus und Tasten</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Tasten</translation>
    </message>
    <message>
        <source>&amp;Mouse and dragging</source>
        <translation>&amp;Maus und Ziehen</translation>
    </message>
    <message>
        <source>%1 › %2 has these keys and will lose them.</source>
        <translation>%1 › %2 hat diese Tasten und verliert sie.</translation>
    </message>
    <message>
        <source>Command or key</source>
        <translation>Befehl oder Taste</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Keys as in another program, for the commands that Soffit has, too</source>
        <translation>Tasten wie in einem anderen Programm, für Befehle, die auch Soffit hat</translation>
    </message>
    <message>
        <source>Reset a&amp;ll</source>
        <translation>&amp;Alle zurücksetzen</translation>
    </message>
    <message>
        <source>As in</source>
        <translation>Wie in</translation>
    </message>
    <message>
        <source>New keys</source>
        <translation>Neue Tasten</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>select; drag a luminaire or the gizmo; elsewhere orbit</source>
        <translation>auswählen; eine Leuchte oder den Manipulator ziehen; sonst um den Raum kreisen</translation>
    </message>
    <message>
        <source>Shift or Ctrl + click</source>
        <translation>Umschalt oder Strg + Klick</translation>
    </message>
    <message>
        <source>add to the selection, remove from it</source>
        <translation>zur Auswahl hinzufügen, daraus entfernen</translation>
    </message>
    <message>
        <source>Shift or Ctrl + drag</source>
        <translation>Umschalt oder Strg + Ziehen</translation>
    </message>
    <message>
        <source>from an empty place: select by a rubber band</source>
        <translation>ab einer leeren Stelle: mit einem Rahmen auswählen</translation>
    </message>
    <message>
        <source>Shift + drag a luminaire</source>
        <translation>Umschalt + Leuchte ziehen</translation>
    </message>
    <message>
        <source>drag a copy</source>
        <translation>eine Kopie ziehen</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Doppelklick</translation>
    </message>
    <message>
        <source>a luminaire: its properties; a surface: its material</source>
        <translation>auf eine Leuchte: ihre Eigenschaften; auf eine Fläche: ihr Material</translation>
    </message>
    <message>
        <source>Middle, or Shift + right</source>
        <translation>Mitte, oder Umschalt + rechts</translation>
    </message>
    <message>
        <source>pan</source>
        <translation>Ansicht verschieben</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>look round</source>
        <translation>umsehen</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>move toward what is under the cursor</source>
        <translation>auf das zugehen, was unter dem Zeiger liegt</translation>
    </message>
    <message>
        <source>While dragging: X, Y, Z</source>
        <translation>Beim Ziehen: X, Y, Z</translation>
    </message>
    <message>
        <source>lock an axis</source>
        <translation>Achse sperren</translation>
    </message>
    <message>
        <source>While dragging: digits</source>
        <translation>Beim Ziehen: Ziffern</translation>
    </message>
    <message>
        <source>type a value, such as 1.2 or 120 cm</source>
        <translation>einen Wert eintippen, etwa 1,2 oder 120 cm</translation>
    </message>
    <message>
        <source>While dragging: Ctrl</source>
        <translation>Beim Ziehen: Strg</translation>
    </message>
    <message>
        <source>whole steps</source>
        <translation>ganze Schritte</translation>
    </message>
    <message>
        <source>While dragging: Alt</source>
        <translation>Beim Ziehen: Alt</translation>
    </message>
    <message>
        <source>do not snap</source>
        <translation>nicht einrasten</translation>
    </message>
    <message>
        <source>Enter, Esc</source>
        <translation>Eingabe, Esc</translation>
    </message>
    <message>
        <source>end a drag; give it up, or select nothing</source>
        <translation>Ziehen beenden; verwerfen oder Auswahl aufheben</translation>
    </message>
    <message>
        <source>1 to 9, Ctrl + 1 to 9</source>
        <translation>1 bis 9, Strg + 1 bis 9</translation>
    </message>
    <message>
        <source>recall a light scene, store one</source>
        <translation>eine Lichtszene abrufen, eine speichern</translation>
    </message>
    <message>
        <source>V</source>
        <translation>V</translation>
    </message>
    <message>
        <source>next layout</source>
        <translation>nächste Variante</translation>
    </message>
    <message>
        <source>Right held: W, A, S, D</source>
        <translation>Rechts gehalten: W, A, S, D</translation>
    </message>
    <message>
        <source>walk; Q down, E up, Shift faster, wheel: speed</source>
        <translation>gehen; Q abwärts, E aufwärts, Umschalt schneller, Rad: Tempo</translation>
    </message>
    <message>
        <source>Plans and sections</source>
        <translation>Grundrisse und Schnitte</translation>
    </message>
    <message>
        <source>drag to shift; Ctrl + wheel moves the cut</source>
        <translation>Ziehen verschiebt; Strg + Rad bewegt den Schnitt</translation>
    </message>
</context>
<context>
    <name>soffit::ui::LayoutsPanel</name>
    <message>
        <source>Layouts</source>
        <translation>Varianten</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>A copy of this layout to change</source>
        <translation>Eine Kopie dieser Variante zum Ändern</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Delete this layout</source>
        <translation>Diese Variante löschen</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Compare the layout shown with another</source>
        <translation>Die angezeigte Variante mit einer anderen vergleichen</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Basis</translation>
    </message>
    <message>
        <source>What all layouts have in common</source>
        <translation>Was alle Varianten gemeinsam haben</translation>
    </message>
    <message>
        <source>F2: rename; drag: another place</source>
        <translation>F2: umbenennen; Ziehen: andere Stelle</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Variante</translation>
    </message>
    <message>
        <source>Duplicate layout</source>
        <translation>Variante duplizieren</translation>
    </message>
    <message>
        <source>Delete layout</source>
        <translation>Variante löschen</translation>
    </message>
    <message>
        <source>Rename layout</source>
        <translation>Variante umbenennen</translation>
    </message>
    <message>
        <source>Move layout</source>
        <translation>Variante verschieben</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
</context>
<context>
    <name>soffit::ui::Legend</name>
    <message>
        <source>Scale of illuminance</source>
        <translation>Skala der Beleuchtungsstärke</translation>
    </message>
    <message>
        <source>Scale of illuminance; a click: its range, steps and colours</source>
        <translation>Skala der Beleuchtungsstärke; ein Klick: Bereich, Stufen und Farben</translation>
    </message>
</context>
<context>
    <name>soffit::ui::LibraryPanel</name>
    <message>
        <source>Search: name, lumens, angle</source>
        <translation>Suche: Name, Lumen, Winkel</translation>
    </message>
    <message>
        <source>Kinds of luminaires</source>
        <translation>Leuchtenarten</translation>
    </message>
    <message>
        <source>Click, then click in the view; or drag it there</source>
        <translation>Anklicken, dann in die Ansicht klicken; oder dorthin ziehen</translation>
    </message>
    <message>
        <source>Folders</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Add a folder of IES and LDT files…</source>
        <translation>Ordner mit IES- und LDT-Dateien hinzufügen…</translation>
    </message>
    <message>
        <source>Forget %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message numerus="yes">
        <source>%n files could not be read</source>
        <translation>
            <numerusform>%n Datei konnte nicht gelesen werden</numerusform>
            <numerusform>%n Dateien konnten nicht gelesen werden</numerusform>
        </translation>
    </message>
    <message>
        <source>Folder of photometric files</source>
        <translation>Ordner mit Photometriedateien</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Wird gelesen…</translation>
    </message>
</context>
<context>
    <name>soffit::ui::LightMarks</name>
    <message>
        <source>Pin probe</source>
        <translation>Messpunkt setzen</translation>
    </message>
    <message>
        <source>Move probe</source>
        <translation>Messpunkt verschieben</translation>
    </message>
    <message>
        <source>%1 %2   %3 cd/m²</source>
        <translation>%1 %2   %3 cd/m²</translation>
    </message>
    <message>
        <source>no light here</source>
        <translation>hier ist kein Licht</translation>
    </message>
</context>
<context>
    <name>soffit::ui::LightsModel</name>
    <message>
        <source>Luminaire</source>
        <translation>Leuchte</translation>
    </message>
    <message>
        <source>Dim</source>
        <translation>Dimmen</translation>
    </message>
    <message>
        <source>Flux</source>
        <translation>Lichtstrom</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Lichtfarbe</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Rename to %1</source>
        <translation>Umbenennen in %1</translation>
    </message>
    <message>
        <source>Change flux</source>
        <translation>Lichtstrom ändern</translation>
    </message>
    <message>
        <source>Change colour temperature</source>
        <translation>Farbtemperatur ändern</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Change group</source>
        <translation>Gruppe ändern</translation>
    </message>
    <message>
        <source>Switch on</source>
        <translation>Einschalten</translation>
    </message>
    <message>
        <source>Switch off</source>
        <translation>Ausschalten</translation>
    </message>
</context>
<context>
    <name>soffit::ui::LightsPanel</name>
    <message>
        <source>Filter by name, group, colour</source>
        <translation>Nach Name, Gruppe, Lichtfarbe filtern</translation>
    </message>
    <message>
        <source>Luminaires</source>
        <translation>Leuchten</translation>
    </message>
    <message>
        <source>Double-click or F2 to edit all that are selected: 80 %, +=10, *=1.2</source>
        <translation>Doppelklick oder F2 bearbeitet alle ausgewählten: 80 %, +=10, *=1,2</translation>
    </message>
</context>
<context>
    <name>soffit::ui::LogPanel</name>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Warning: %1</source>
        <translation>Warnung: %1</translation>
    </message>
</context>
<context>
    <name>soffit::ui::LuminairePanel</name>
    <message>
        <source>Switched on</source>
        <translation>Eingeschaltet</translation>
    </message>
    <message>
        <source>Dimming</source>
        <translation>Dimmwert</translation>
    </message>
    <message>
        <source>Share of the full flux</source>
        <translation>Anteil am vollen Lichtstrom</translation>
    </message>
    <message>
        <source>Luminous flux over the whole luminaire, undimmed: 1200 lm, 1.2 klm</source>
        <translation>Lichtstrom der ganzen Leuchte, ungedimmt: 1200 lm, 1,2 klm</translation>
    </message>
    <message>
        <source>Correlated colour temperature</source>
        <translation>Ähnlichste Farbtemperatur</translation>
    </message>
    <message>
        <source>mixed or none</source>
        <translation>gemischt oder keine</translation>
    </message>
    <message>
        <source>Its body casts shadows</source>
        <translation>Leuchtenkörper wirft Schatten</translation>
    </message>
    <message>
        <source>Flux</source>
        <translation>Lichtstrom</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Lichtfarbe</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>x, y, z of the luminaire&apos;s origin: 3.2 m, 320 cm, 10&apos; 6&quot;</source>
        <translation>x, y, z des Leuchtenursprungs: 3,2 m, 320 cm, 10&apos; 6&quot;</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>About the fixed x, y and z axes, in that order: 40 deg</source>
        <translation>Um die festen Achsen x, y und z, in dieser Reihenfolge: 40 deg</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Switch on</source>
        <translation>Einschalten</translation>
    </message>
    <message>
        <source>Switch off</source>
        <translation>Ausschalten</translation>
    </message>
    <message>
        <source>Dim</source>
        <translation>Dimmen</translation>
    </message>
    <message>
        <source>Change flux</source>
        <translation>Lichtstrom ändern</translation>
    </message>
    <message>
        <source>Change colour temperature</source>
        <translation>Farbtemperatur ändern</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Change shape</source>
        <translation>Form ändern</translation>
    </message>
    <message>
        <source>Change group</source>
        <translation>Gruppe ändern</translation>
    </message>
    <message>
        <source>Let it cast shadows</source>
        <translation>Schatten werfen lassen</translation>
    </message>
    <message>
        <source>Let it cast no shadows</source>
        <translation>Keinen Schatten werfen lassen</translation>
    </message>
    <message>
        <source>Select a luminaire in the view or in the list.</source>
        <translation>Eine Leuchte in der Ansicht oder in der Liste auswählen.</translation>
    </message>
    <message numerus="yes">
        <source>%n luminaires</source>
        <translation>
            <numerusform>%n Leuchte</numerusform>
            <numerusform>%n Leuchten</numerusform>
        </translation>
    </message>
    <message>
        <source>RGB</source>
        <translation>RGB</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>gemischt</translation>
    </message>
</context>
<context>
    <name>soffit::ui::LuxScaleFields</name>
    <message>
        <source>Logarithmic</source>
        <translation>Logarithmisch</translation>
    </message>
    <message>
        <source>Least illuminance of the scale</source>
        <translation>Kleinste Beleuchtungsstärke der Skala</translation>
    </message>
    <message>
        <source>Greatest illuminance of the scale</source>
        <translation>Größte Beleuchtungsstärke der Skala</translation>
    </message>
    <message>
        <source>Violet to yellow</source>
        <translation>Violett bis Gelb</translation>
    </message>
    <message>
        <source>Blue to yellow</source>
        <translation>Blau bis Gelb</translation>
    </message>
    <message>
        <source>Greys</source>
        <translation>Grautöne</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>Safe for color blindness and prints</source>
        <translation>Auch bei Farbenblindheit und im Druck lesbar</translation>
    </message>
    <message>
        <source>As in other programs; red and green look alike to many</source>
        <translation>Wie in anderen Programmen; Rot und Grün sehen für viele gleich aus</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Stufenlos</translation>
    </message>
    <message>
        <source>Bands of one colour each</source>
        <translation>Stufen von je einer Farbe</translation>
    </message>
    <message>
        <source>Round values</source>
        <translation>Runde Werte</translation>
    </message>
    <message>
        <source>Standard series</source>
        <translation>Normreihe</translation>
    </message>
    <message>
        <source>Own values</source>
        <translation>Eigene Werte</translation>
    </message>
    <message>
        <source>Standard series: 0.5 1 2 3 5 7.5 10 … 500 750 1000 …</source>
        <translation>Normreihe: 0,5 1 2 3 5 7,5 10 … 500 750 1000 …</translation>
    </message>
    <message>
        <source>300, 500, 750</source>
        <translation>300, 500, 750</translation>
    </message>
    <message>
        <source>Values of the isolux lines</source>
        <translation>Werte der Isoluxlinien</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skala</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Lines at</source>
        <translation>Linien bei</translation>
    </message>
</context>
<context>
    <name>soffit::ui::MainWindow</name>
    <message>
        <source>Select the luminaire that is to be repeated first.</source>
        <translation>Zuerst die Leuchte auswählen, die wiederholt werden soll.</translation>
    </message>
    <message>
        <source>&amp;Line</source>
        <translation>&amp;Linie</translation>
    </message>
    <message>
        <source>&amp;Rectangle</source>
        <translation>&amp;Rechteck</translation>
    </message>
    <message>
        <source>&amp;Circle</source>
        <translation>&amp;Kreis</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Z</source>
        <translation>Ctrl+Shift+Z</translation>
    </message>
    <message>
        <source>Ctrl+Y</source>
        <translation>Ctrl+Y</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>A&amp;usschneiden</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>Not pasted</source>
        <translation>Nicht eingefügt</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Duplizieren</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>&amp;Alles auswählen</translation>
    </message>
    <message>
        <source>&amp;Snap to</source>
        <translation>E&amp;inrasten an</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>&amp;Verschieben</translation>
    </message>
    <message>
        <source>&amp;Rotate</source>
        <translation>D&amp;rehen</translation>
    </message>
    <message>
        <source>Resi&amp;ze</source>
        <translation>&amp;Größe ändern</translation>
    </message>
    <message>
        <source>&amp;Ceiling and walls</source>
        <translation>&amp;Decke und Wänden</translation>
    </message>
    <message>
        <source>Also the middle between two walls</source>
        <translation>Auch in der Mitte zwischen zwei Wänden</translation>
    </message>
    <message>
        <source>Other &amp;luminaires</source>
        <translation>Anderen &amp;Leuchten</translation>
    </message>
    <message>
        <source>Their axes, and their spacing carried on</source>
        <translation>An ihren Achsen und mit gleichem Abstand weiter</translation>
    </message>
    <message>
        <source>&amp;Grid of 0.1 m</source>
        <translation>&amp;Raster von 0,1 m</translation>
    </message>
    <message>
        <source>Where nothing else attracts; Ctrl while dragging does the same</source>
        <translation>Wo sonst nichts anzieht; Strg beim Ziehen bewirkt dasselbe</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>An empty project</source>
        <translation>Ein leeres Projekt</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>&amp;Import a model…</source>
        <translation>Modell &amp;importieren…</translation>
    </message>
    <message>
        <source>Ctrl+I</source>
        <translation>Ctrl+I</translation>
    </message>
    <message>
        <source>Architecture or furniture, into a new project or this one</source>
        <translation>Architektur oder Möbel, in ein neues Projekt oder in dieses</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Noch keine</translation>
    </message>
    <message>
        <source>&amp;Close project</source>
        <translation>Projekt s&amp;chließen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>&amp;Export the view…</source>
        <translation>&amp;Ansicht exportieren…</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>A picture of the view at any size, without gizmo and outlines</source>
        <translation>Ein Bild der Ansicht in beliebiger Größe, ohne Manipulator und Umrisse</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>From cameras and of layouts, into a folder</source>
        <translation>Aus Kameras und von Varianten, in einen Ordner</translation>
    </message>
    <message>
        <source>Cop&amp;y the picture</source>
        <translation>Bild &amp;kopieren</translation>
    </message>
    <message>
        <source>Ctrl+Shift+C</source>
        <translation>Ctrl+Shift+C</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Ctrl+Q</source>
        <translation>Ctrl+Q</translation>
    </message>
    <message>
        <source>Photometric file</source>
        <translation>Photometriedatei</translation>
    </message>
    <message>
        <source>Photometry (*.ies *.IES *.ldt *.LDT)</source>
        <translation>Photometrie (*.ies *.IES *.ldt *.LDT)</translation>
    </message>
    <message>
        <source>The file was not read</source>
        <translation>Die Datei wurde nicht gelesen</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Mesh</translation>
    </message>
    <message>
        <source>Models (*.obj *.OBJ *.ply *.stl *.glb *.gltf)</source>
        <translation>Modelle (*.obj *.OBJ *.ply *.stl *.glb *.gltf)</translation>
    </message>
    <message>
        <source>The mesh was not read</source>
        <translation>Das Mesh wurde nicht gelesen</translation>
    </message>
    <message>
        <source>&amp;Insert</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>From a &amp;photometric file…</source>
        <translation>Aus &amp;Photometriedatei…</translation>
    </message>
    <message>
        <source>From a &amp;mesh file…</source>
        <translation>Aus &amp;Mesh-Datei…</translation>
    </message>
    <message>
        <source>OBJ and other models</source>
        <translation>OBJ und andere Modelle</translation>
    </message>
    <message>
        <source>Make &amp;luminous</source>
        <translation>&amp;Leuchtend machen</translation>
    </message>
    <message>
        <source>Click a part of the building that is to give light</source>
        <translation>Einen Teil des Gebäudes anklicken, der leuchten soll</translation>
    </message>
    <message>
        <source>&amp;Draw a luminaire</source>
        <translation>Leuchte &amp;zeichnen</translation>
    </message>
    <message>
        <source>Corner by corner, on the ceiling</source>
        <translation>Ecke für Ecke, auf der Decke</translation>
    </message>
    <message>
        <source>L&amp;ayouts</source>
        <translation>&amp;Varianten</translation>
    </message>
    <message>
        <source>&amp;Duplicate the layout shown</source>
        <translation>Angezeigte Variante &amp;duplizieren</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Ctrl+L</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>&amp;Umbenennen…</translation>
    </message>
    <message>
        <source>De&amp;lete the layout shown</source>
        <translation>Angezeigte Variante &amp;löschen</translation>
    </message>
    <message>
        <source>Move &amp;up</source>
        <translation>Nach &amp;oben</translation>
    </message>
    <message>
        <source>Move do&amp;wn</source>
        <translation>Nach un&amp;ten</translation>
    </message>
    <message>
        <source>&amp;Next layout</source>
        <translation>Nä&amp;chste Variante</translation>
    </message>
    <message>
        <source>Compare with a &amp;slider</source>
        <translation>Vergleichen mit &amp;Schieber</translation>
    </message>
    <message>
        <source>Compare side &amp;by side</source>
        <translation>&amp;Nebeneinander vergleichen</translation>
    </message>
    <message>
        <source>Bl&amp;ink</source>
        <translation>&amp;Blinken</translation>
    </message>
    <message>
        <source>This layout and another in turn; again: stop</source>
        <translation>Diese Variante und eine andere im Wechsel; nochmals: Ende</translation>
    </message>
    <message>
        <source>Difference in lu&amp;x</source>
        <translation>Differenz in Lu&amp;x</translation>
    </message>
    <message>
        <source>&amp;End the comparison</source>
        <translation>Vergleich b&amp;eenden</translation>
    </message>
    <message>
        <source>Shift+B</source>
        <translation>Shift+B</translation>
    </message>
    <message>
        <source>&amp;Luminaire</source>
        <translation>&amp;Leuchte</translation>
    </message>
    <message>
        <source>Switch &amp;on or off</source>
        <translation>&amp;Ein- oder ausschalten</translation>
    </message>
    <message>
        <source>&amp;Dim to</source>
        <translation>&amp;Dimmen auf</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>&amp;Aim at…</source>
        <translation>&amp;Ausrichten auf…</translation>
    </message>
    <message>
        <source>Click the point of a surface that the selection is to light</source>
        <translation>Den Punkt einer Fläche anklicken, den die Auswahl beleuchten soll</translation>
    </message>
    <message>
        <source>A&amp;rray</source>
        <translation>An&amp;ordnung</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>Aus&amp;blenden</translation>
    </message>
    <message>
        <source>Hide o&amp;thers</source>
        <translation>A&amp;ndere ausblenden</translation>
    </message>
    <message>
        <source>Shift+H</source>
        <translation>Shift+H</translation>
    </message>
    <message>
        <source>&amp;Show all</source>
        <translation>Alle e&amp;inblenden</translation>
    </message>
    <message>
        <source>Ctrl+H</source>
        <translation>Ctrl+H</translation>
    </message>
    <message>
        <source>&amp;Light scenes</source>
        <translation>&amp;Lichtszenen</translation>
    </message>
    <message>
        <source>Recall scene %1</source>
        <translation>Szene %1 abrufen</translation>
    </message>
    <message>
        <source>Store scene %1</source>
        <translation>Szene %1 speichern</translation>
    </message>
    <message>
        <source>The project was not opened</source>
        <translation>Das Projekt wurde nicht geöffnet</translation>
    </message>
    <message>
        <source>opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>Soffit</source>
        <translation>Soffit</translation>
    </message>
    <message>
        <source>%1[*] – Soffit</source>
        <translation>%1[*] – Soffit</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>Frame &amp;all</source>
        <translation>&amp;Alles einpassen</translation>
    </message>
    <message>
        <source>Frame &amp;selection</source>
        <translation>Aus&amp;wahl einpassen</translation>
    </message>
    <message>
        <source>Shift+Home</source>
        <translation>Shift+Home</translation>
    </message>
    <message>
        <source>&amp;False colours</source>
        <translation>&amp;Falschfarben</translation>
    </message>
    <message>
        <source>Illuminance by colour, with a scale</source>
        <translation>Beleuchtungsstärke als Farbe, mit Skala</translation>
    </message>
    <message>
        <source>&amp;Brighter</source>
        <translation>&amp;Heller</translation>
    </message>
    <message>
        <source>Ctrl+Up</source>
        <translation>Ctrl+Up</translation>
    </message>
    <message>
        <source>&amp;Darker</source>
        <translation>&amp;Dunkler</translation>
    </message>
    <message>
        <source>Ctrl+Down</source>
        <translation>Ctrl+Down</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>Farbs&amp;chema</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>&amp;Fenster</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Ctrl+Shift+P</source>
        <translation>Ctrl+Shift+P</translation>
    </message>
    <message>
        <source>Run any command by a few letters of its name</source>
        <translation>Jeden Befehl über einige Buchstaben seines Namens ausführen</translation>
    </message>
    <message>
        <source>What the mouse does, and the keys of all commands, to change</source>
        <translation>Was die Maus tut, und die Tasten aller Befehle, zum Ändern</translation>
    </message>
    <message>
        <source>?</source>
        <translation>?</translation>
    </message>
    <message>
        <source>&amp;About Soffit</source>
        <translation>Ü&amp;ber Soffit</translation>
    </message>
    <message>
        <source>&amp;Results</source>
        <translation>E&amp;rgebnisse</translation>
    </message>
    <message>
        <source>Show the &amp;table</source>
        <translation>&amp;Tabelle anzeigen</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Ctrl+R</translation>
    </message>
    <message>
        <source>&amp;Copy the table</source>
        <translation>Tabelle &amp;kopieren</translation>
    </message>
    <message>
        <source>As text for a spreadsheet</source>
        <translation>Als Text für eine Tabellenkalkulation</translation>
    </message>
    <message>
        <source>&amp;Export the table…</source>
        <translation>Tabelle &amp;exportieren…</translation>
    </message>
    <message>
        <source>The figures of all layouts as comma-separated values</source>
        <translation>Die Zahlen aller Varianten als durch Kommas getrennte Werte</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>The language changes when Soffit is started again.</source>
        <translation>Die Sprache wechselt beim nächsten Start von Soffit.</translation>
    </message>
    <message>
        <source>Sa&amp;mple projects</source>
        <translation>Beispiel&amp;projekte</translation>
    </message>
    <message>
        <source>Export a se&amp;t of pictures…</source>
        <translation>Bilderserie e&amp;xportieren…</translation>
    </message>
    <message>
        <source>&amp;Contents</source>
        <translation>&amp;Inhalt</translation>
    </message>
    <message>
        <source>How Soffit is used, with a search; from a panel: the page on it</source>
        <translation>Wie Soffit benutzt wird, mit Suche; aus einem Fenster: die Seite dazu</translation>
    </message>
    <message>
        <source>Co&amp;mmands…</source>
        <translation>Befe&amp;hle…</translation>
    </message>
    <message>
        <source>Mouse and &amp;keys</source>
        <translation>Maus und &amp;Tasten</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>Blick&amp;richtung</translation>
    </message>
    <message>
        <source>Pre&amp;vious place</source>
        <translation>&amp;Voriger Standort</translation>
    </message>
    <message>
        <source>Alt+Left</source>
        <translation>Alt+Left</translation>
    </message>
    <message>
        <source>Back to where this view was looked from before</source>
        <translation>Dorthin zurück, von wo diese Ansicht zuvor gesehen wurde</translation>
    </message>
    <message>
        <source>&amp;Next place</source>
        <translation>&amp;Nächster Standort</translation>
    </message>
    <message>
        <source>Alt+Right</source>
        <translation>Alt+Right</translation>
    </message>
    <message>
        <source>Forward again after going back</source>
        <translation>Nach dem Zurückgehen wieder vor</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>&amp;Perspektive</translation>
    </message>
    <message>
        <source>Alt+1</source>
        <translation>Alt+1</translation>
    </message>
    <message>
        <source>As the eye sees; as it was left</source>
        <translation>Wie das Auge sieht; wie zuletzt verlassen</translation>
    </message>
    <message>
        <source>P&amp;lan</source>
        <translation>&amp;Grundriss</translation>
    </message>
    <message>
        <source>From above, cut above the tables</source>
        <translation>Von oben, über den Tischen geschnitten</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>&amp;Vorderansicht</translation>
    </message>
    <message>
        <source>Alt+2</source>
        <translation>Alt+2</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Rückansicht</translation>
    </message>
    <message>
        <source>Alt+3</source>
        <translation>Alt+3</translation>
    </message>
    <message>
        <source>L&amp;eft side</source>
        <translation>L&amp;inke Seite</translation>
    </message>
    <message>
        <source>Alt+4</source>
        <translation>Alt+4</translation>
    </message>
    <message>
        <source>&amp;Right side</source>
        <translation>R&amp;echte Seite</translation>
    </message>
    <message>
        <source>Alt+5</source>
        <translation>Alt+5</translation>
    </message>
    <message>
        <source>&amp;Section from the front</source>
        <translation>&amp;Schnitt von vorn</translation>
    </message>
    <message>
        <source>Alt+6</source>
        <translation>Alt+6</translation>
    </message>
    <message>
        <source>Section from the b&amp;ack</source>
        <translation>Schnitt von &amp;hinten</translation>
    </message>
    <message>
        <source>Alt+7</source>
        <translation>Alt+7</translation>
    </message>
    <message>
        <source>Section from the lef&amp;t</source>
        <translation>Schnitt von &amp;links</translation>
    </message>
    <message>
        <source>Alt+8</source>
        <translation>Alt+8</translation>
    </message>
    <message>
        <source>Section from the ri&amp;ght</source>
        <translation>Schnitt von re&amp;chts</translation>
    </message>
    <message>
        <source>Alt+9</source>
        <translation>Alt+9</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>S&amp;prache</translation>
    </message>
    <message>
        <source>Vie&amp;ws</source>
        <translation>Ansich&amp;ten</translation>
    </message>
    <message>
        <source>&amp;Cameras</source>
        <translation>&amp;Kameras</translation>
    </message>
    <message>
        <source>&amp;Save view as camera</source>
        <translation>Ansicht als Kamera &amp;speichern</translation>
    </message>
    <message>
        <source>&amp;Next camera</source>
        <translation>&amp;Nächste Kamera</translation>
    </message>
    <message>
        <source>&amp;Previous camera</source>
        <translation>&amp;Vorige Kamera</translation>
    </message>
    <message>
        <source>&amp;One</source>
        <translation>&amp;Eine</translation>
    </message>
    <message>
        <source>Ctrl+Alt+1</source>
        <translation>Ctrl+Alt+1</translation>
    </message>
    <message>
        <source>Two &amp;beside each other</source>
        <translation>Zwei &amp;nebeneinander</translation>
    </message>
    <message>
        <source>Ctrl+Alt+2</source>
        <translation>Ctrl+Alt+2</translation>
    </message>
    <message>
        <source>Two, one o&amp;ver the other</source>
        <translation>Zwei ü&amp;bereinander</translation>
    </message>
    <message>
        <source>Ctrl+Alt+3</source>
        <translation>Ctrl+Alt+3</translation>
    </message>
    <message>
        <source>&amp;Four</source>
        <translation>&amp;Vier</translation>
    </message>
    <message>
        <source>Ctrl+Alt+4</source>
        <translation>Ctrl+Alt+4</translation>
    </message>
    <message>
        <source>&amp;Calculate</source>
        <translation>Bere&amp;chnen</translation>
    </message>
    <message>
        <source>&amp;Verify with the path tracer</source>
        <translation>Mit dem Pfadverfolger &amp;prüfen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+V</source>
        <translation>Ctrl+Shift+V</translation>
    </message>
    <message>
        <source>Computes the light independently in the background and compares</source>
        <translation>Berechnet das Licht im Hintergrund unabhängig und vergleicht</translation>
    </message>
    <message>
        <source>Show the &amp;errors in the view</source>
        <translation>&amp;Fehler in der Ansicht zeigen</translation>
    </message>
    <message>
        <source>Of the points that were verified</source>
        <translation>Der geprüften Punkte</translation>
    </message>
    <message>
        <source>&amp;Quality and times</source>
        <translation>&amp;Qualität und Zeiten</translation>
    </message>
    <message>
        <source>&amp;Stop computing</source>
        <translation>Berechnung &amp;abbrechen</translation>
    </message>
    <message>
        <source>Gives up the precomputation or the verification under way</source>
        <translation>Bricht die laufende Vorberechnung oder Prüfung ab</translation>
    </message>
    <message>
        <source>&amp;Isolux lines</source>
        <translation>&amp;Isoluxlinien</translation>
    </message>
    <message>
        <source>Lines of equal illuminance, on surfaces or work planes</source>
        <translation>Linien gleicher Beleuchtungsstärke, auf Flächen oder Nutzebenen</translation>
    </message>
    <message>
        <source>Wor&amp;k plane values</source>
        <translation>Werte der Nut&amp;zebenen</translation>
    </message>
    <message>
        <source>Illuminance in numbers at the points of the work planes</source>
        <translation>Beleuchtungsstärke in Zahlen an den Punkten der Nutzebenen</translation>
    </message>
    <message>
        <source>&amp;Units</source>
        <translation>&amp;Einheiten</translation>
    </message>
    <message>
        <source>&amp;Pin a probe</source>
        <translation>&amp;Messpunkt setzen</translation>
    </message>
    <message>
        <source>Watches the light at the surface under the cursor</source>
        <translation>Beobachtet das Licht auf der Fläche unter dem Zeiger</translation>
    </message>
    <message>
        <source>Pro&amp;file along a line…</source>
        <translation>&amp;Profil entlang einer Linie…</translation>
    </message>
    <message>
        <source>Shift+P</source>
        <translation>Shift+P</translation>
    </message>
    <message>
        <source>Click two points of a surface: the light between them as a chart</source>
        <translation>Zwei Punkte einer Fläche anklicken: das Licht dazwischen als Diagramm</translation>
    </message>
    <message>
        <source>How values are shown; files stay metric</source>
        <translation>Wie Werte gezeigt werden; Dateien bleiben metrisch</translation>
    </message>
    <message>
        <source>Metric: m, lx</source>
        <translation>Metrisch: m, lx</translation>
    </message>
    <message>
        <source>Imperial: ft, fc</source>
        <translation>Angloamerikanisch: ft, fc</translation>
    </message>
    <message>
        <source>Ray traced at rest</source>
        <translation>Strahlverfolgt in Ruhe</translation>
    </message>
    <message>
        <source>Reflections and exact shadows, some seconds after nothing moves any more</source>
        <translation>Spiegelungen und genaue Schatten, einige Sekunden nachdem sich nichts mehr bewegt</translation>
    </message>
    <message>
        <source>Reflections</source>
        <translation>Spiegelungen</translation>
    </message>
    <message>
        <source>What shiny surfaces reflect, following every move; without them the view is a little quicker</source>
        <translation>Was glänzende Flächen spiegeln, bei jeder Bewegung; ohne sie ist die Ansicht etwas schneller</translation>
    </message>
    <message>
        <source>Which processor evaluates light in the views; pictures are the same</source>
        <translation>Welcher Prozessor das Licht in den Ansichten auswertet; die Bilder sind dieselben</translation>
    </message>
    <message>
        <source>&amp;Automatic</source>
        <translation>&amp;Automatisch</translation>
    </message>
    <message>
        <source>By shaders where there is a graphics processor</source>
        <translation>Durch Shader, wo es einen Grafikprozessor gibt</translation>
    </message>
    <message>
        <source>&amp;Processor</source>
        <translation>&amp;Prozessor</translation>
    </message>
    <message>
        <source>&amp;Graphics processor</source>
        <translation>&amp;Grafikprozessor</translation>
    </message>
    <message>
        <source>&amp;Evaluation</source>
        <translation>A&amp;uswertung</translation>
    </message>
</context>
<context>
    <name>soffit::ui::MakingLuminous</name>
    <message>
        <source>too large a part</source>
        <translation>Teil zu groß</translation>
    </message>
    <message>
        <source>Click the part of the building that is to give light. Shift: several. Esc: done.</source>
        <translation>Den Teil des Gebäudes anklicken, der leuchten soll. Umschalt: mehrere. Esc: fertig.</translation>
    </message>
</context>
<context>
    <name>soffit::ui::MaterialsPanel</name>
    <message>
        <source>Materials</source>
        <translation>Materialien</translation>
    </message>
    <message>
        <source>Reflectance</source>
        <translation>Reflexionsgrad</translation>
    </message>
    <message>
        <source>Reflectance ρ: the share of white light that comes back</source>
        <translation>Reflexionsgrad ρ: Anteil weißen Lichts, der zurückkommt</translation>
    </message>
    <message>
        <source>More than 90 %: white paint reaches 85 to 90 %</source>
        <translation>Mehr als 90 %: weiße Farbe erreicht 85 bis 90 %</translation>
    </message>
    <message>
        <source>Its colour; the reflectance stays</source>
        <translation>Die Farbe; der Reflexionsgrad bleibt</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Auswählen…</translation>
    </message>
    <message>
        <source>Gloss seen straight on: 4 % for paint, wood and plastics, more for metals</source>
        <translation>Glanz senkrecht gesehen: 4 % für Anstrich, Holz und Kunststoff, mehr für Metalle</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Rauheit</translation>
    </message>
    <message>
        <source>0 % is a mirror, 100 % the widest gloss</source>
        <translation>0 % ist ein Spiegel, 100 % der breiteste Glanz</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Specular</source>
        <translation>Glanz</translation>
    </message>
    <message>
        <source>Change reflectance</source>
        <translation>Reflexionsgrad ändern</translation>
    </message>
    <message>
        <source>Change gloss</source>
        <translation>Glanz ändern</translation>
    </message>
    <message>
        <source>Change roughness</source>
        <translation>Rauheit ändern</translation>
    </message>
    <message>
        <source>Change colour</source>
        <translation>Farbe ändern</translation>
    </message>
    <message>
        <source>glass</source>
        <translation>Glas</translation>
    </message>
    <message>
        <source>Glass: it lets light through and mirrors some; it has no colour of its own.</source>
        <translation>Glas: lässt Licht durch und spiegelt etwas davon; eine eigene Farbe hat es nicht.</translation>
    </message>
    <message>
        <source>Its picture %1 is multiplied by the colour.</source>
        <translation>Sein Bild %1 wird mit der Farbe multipliziert.</translation>
    </message>
    <message>
        <source>Clear glass</source>
        <translation>Klares Glas</translation>
    </message>
    <message>
        <source>A sheet that light shines through; the building is computed anew</source>
        <translation>Eine Scheibe, durch die Licht scheint; das Gebäude wird neu berechnet</translation>
    </message>
    <message>
        <source>Of the whole sheet, seen straight on; double glazing has two</source>
        <translation>Der ganzen Scheibe, senkrecht gesehen; Isolierglas hat zwei</translation>
    </message>
    <message>
        <source>Transmittance</source>
        <translation>Transmissionsgrad</translation>
    </message>
    <message>
        <source>Glass</source>
        <translation>Glas</translation>
    </message>
    <message>
        <source>The roughness is multiplied by the picture %1.</source>
        <translation>Die Rauheit wird mit dem Bild %1 multipliziert.</translation>
    </message>
</context>
<context>
    <name>soffit::ui::MixerPanel</name>
    <message>
        <source>Luminaires with the same group are mixed here.</source>
        <translation>Leuchten derselben Leuchtengruppe werden hier gemischt.</translation>
    </message>
    <message>
        <source>Scenes</source>
        <translation>Szenen</translation>
    </message>
    <message>
        <source>Store what is lit now as a scene</source>
        <translation>Das jetzige Licht als Szene speichern</translation>
    </message>
    <message>
        <source>Colour of the light</source>
        <translation>Farbe des Lichts</translation>
    </message>
    <message>
        <source>%1 (key %2). Right-click: rename, store, delete</source>
        <translation>%1 (Taste %2). Rechtsklick: umbenennen, speichern, löschen</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>&amp;Umbenennen…</translation>
    </message>
    <message>
        <source>Light scene</source>
        <translation>Lichtszene</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>&amp;Store what is lit now</source>
        <translation>Jetziges Licht &amp;speichern</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
</context>
<context>
    <name>soffit::ui::PictureDialog</name>
    <message>
        <source>Base</source>
        <translation>Basis</translation>
    </message>
    <message>
        <source>Export the view</source>
        <translation>Ansicht exportieren</translation>
    </message>
    <message>
        <source>Export a set of pictures</source>
        <translation>Bilderserie exportieren</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>Layouts</source>
        <translation>Varianten</translation>
    </message>
    <message>
        <source>As the view, %1 × %2</source>
        <translation>Wie die Ansicht, %1 × %2</translation>
    </message>
    <message>
        <source>Twice the view, %1 × %2</source>
        <translation>Doppelte Ansicht, %1 × %2</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Andere</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>PNG, as it is seen</source>
        <translation>PNG, wie angezeigt</translation>
    </message>
    <message>
        <source>JPEG, as it is seen</source>
        <translation>JPEG, wie angezeigt</translation>
    </message>
    <message>
        <source>TIFF, as it is seen</source>
        <translation>TIFF, wie angezeigt</translation>
    </message>
    <message>
        <source>OpenEXR, luminance in cd/m²</source>
        <translation>OpenEXR, Leuchtdichte in cd/m²</translation>
    </message>
    <message>
        <source>Legend of false colours</source>
        <translation>Legende der Falschfarben</translation>
    </message>
    <message>
        <source>Title: project, layout and camera</source>
        <translation>Titel: Projekt, Variante und Kamera</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message numerus="yes">
        <source>%n picture(s)</source>
        <translation>
            <numerusform>%n Bild</numerusform>
            <numerusform>%n Bilder</numerusform>
        </translation>
    </message>
    <message>
        <source>Ray traced: reflections, exact shadows</source>
        <translation>Strahlverfolgt: Spiegelungen, genaue Schatten</translation>
    </message>
    <message>
        <source>Rendering</source>
        <translation>Berechnung</translation>
    </message>
    <message>
        <source>As the live view</source>
        <translation>Wie die lebende Ansicht</translation>
    </message>
    <message>
        <source>Ray traced pictures take seconds to minutes. False colours, isolux lines and flat views are always drawn live.</source>
        <translation>Strahlverfolgte Bilder dauern Sekunden bis Minuten. Falschfarben, Isoluxlinien und flache Ansichten werden immer wie die lebende Ansicht gezeichnet.</translation>
    </message>
</context>
<context>
    <name>soffit::ui::PictureExport</name>
    <message>
        <source>Wrote %1</source>
        <translation>%1 geschrieben</translation>
    </message>
    <message>
        <source>Export the view</source>
        <translation>Ansicht exportieren</translation>
    </message>
    <message>
        <source>Pictures (*.%1)</source>
        <translation>Bilder (*.%1)</translation>
    </message>
    <message>
        <source>The project has no cameras</source>
        <translation>Das Projekt hat keine Kameras</translation>
    </message>
    <message>
        <source>Folder for the pictures</source>
        <translation>Ordner für die Bilder</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Basis</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>taking pictures</source>
        <translation>Bilder werden aufgenommen</translation>
    </message>
    <message>
        <source>Save views in the Cameras panel: the set takes a picture from each.</source>
        <translation>Speichern Sie Ansichten im Fenster „Kameras“: Die Serie nimmt aus jeder ein Bild auf.</translation>
    </message>
    <message>
        <source>There is no light to take a picture of yet. Wait until the first light is computed.</source>
        <translation>Es gibt noch kein Licht, das sich aufnehmen ließe. Warten Sie, bis das erste Licht berechnet ist.</translation>
    </message>
    <message>
        <source>%1 is drawn as in the view: false colours, isolux lines and flat views are not traced</source>
        <translation>%1 wird wie in der Ansicht gezeichnet: Falschfarben, Isoluxlinien und flache Ansichten werden nicht verfolgt</translation>
    </message>
</context>
<context>
    <name>soffit::ui::PictureJob</name>
    <message>
        <source>There is not enough memory for a picture of %1 × %2 pixels. Choose a smaller size.</source>
        <translation>Der Speicher reicht nicht für ein Bild von %1 × %2 Pixeln. Wählen Sie eine kleinere Größe.</translation>
    </message>
</context>
<context>
    <name>soffit::ui::Placing</name>
    <message>
        <source>Place %1</source>
        <translation>%1 platzieren</translation>
    </message>
    <message>
        <source>%1: click where it goes. Space: turn. Shift: place several. Alt: no snapping. Esc: done.</source>
        <translation>%1: Einbauort anklicken. Leertaste: drehen. Umschalt: mehrere platzieren. Alt: nicht einrasten. Esc: fertig.</translation>
    </message>
</context>
<context>
    <name>soffit::ui::ProbesPanel</name>
    <message>
        <source>Probes</source>
        <translation>Messpunkte</translation>
    </message>
    <message>
        <source>Who lights the probe</source>
        <translation>Wer den Messpunkt beleuchtet</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Removes the chosen probe (Del)</source>
        <translation>Entfernt den gewählten Messpunkt (Entf)</translation>
    </message>
    <message>
        <source>P pins one under the cursor</source>
        <translation>P setzt einen unter dem Zeiger</translation>
    </message>
    <message>
        <source>Remove probe</source>
        <translation>Messpunkt entfernen</translation>
    </message>
    <message>
        <source>Rename probe</source>
        <translation>Messpunkt umbenennen</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Messpunkt</translation>
    </message>
    <message>
        <source>Who lights a probe</source>
        <translation>Wer einen Messpunkt beleuchtet</translation>
    </message>
    <message>
        <source>Who lights %1</source>
        <translation>Wer %1 beleuchtet</translation>
    </message>
    <message>
        <source>Luminaire</source>
        <translation>Leuchte</translation>
    </message>
    <message>
        <source>Light from outside</source>
        <translation>Licht von außen</translation>
    </message>
</context>
<context>
    <name>soffit::ui::ProfileChart</name>
    <message>
        <source>Illuminance along a line</source>
        <translation>Beleuchtungsstärke entlang einer Linie</translation>
    </message>
    <message>
        <source>Close the profile</source>
        <translation>Profil schließen</translation>
    </message>
    <message>
        <source>No lit surface along the line</source>
        <translation>Keine beleuchtete Fläche entlang der Linie</translation>
    </message>
    <message>
        <source>Ēm %1   Emin %2   Emax %3 %4</source>
        <translation>Ēm %1   Emin %2   Emax %3 %4</translation>
    </message>
</context>
<context>
    <name>soffit::ui::ProjectFiles</name>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
    <message>
        <source>No project can be made</source>
        <translation>Es kann kein Projekt angelegt werden</translation>
    </message>
    <message>
        <source>The folder %1 cannot be written.</source>
        <translation>Der Ordner %1 ist nicht beschreibbar.</translation>
    </message>
    <message>
        <source>importing %1</source>
        <translation>%1 wird importiert</translation>
    </message>
    <message>
        <source>The model was not imported</source>
        <translation>Das Modell wurde nicht importiert</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>%1 importieren</translation>
    </message>
</context>
<context>
    <name>soffit::ui::ProjectSession</name>
    <message>
        <source>The picture was not written</source>
        <translation>Das Bild wurde nicht geschrieben</translation>
    </message>
    <message>
        <source>Computing the first light…</source>
        <translation>Das erste Licht wird berechnet…</translation>
    </message>
    <message>
        <source>The precomputation was cancelled</source>
        <translation>Die Vorberechnung wurde abgebrochen</translation>
    </message>
    <message>
        <source>No light was computed</source>
        <translation>Es wurde kein Licht berechnet</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 geschrieben</translation>
    </message>
    <message>
        <source>Drop the model of a building here, or import one: File ▸ Import a model</source>
        <translation>Ein Gebäudemodell hier ablegen oder importieren: Datei ▸ Modell importieren</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Belichtung</translation>
    </message>
    <message>
        <source>Plans and sections are always there: choose a perspective to save it as a camera.</source>
        <translation>Grundrisse und Schnitte sind immer da: Wählen Sie eine Perspektive, um sie als Kamera zu speichern.</translation>
    </message>
    <message>
        <source>Verified: RMS %1 %</source>
        <translation>Geprüft: RMS %1 %</translation>
    </message>
    <message>
        <source>The picture was not read</source>
        <translation>Das Bild wurde nicht gelesen</translation>
    </message>
    <message>
        <source>Light from outside was left out; any change of it computes it again</source>
        <translation>Das Licht von außen wurde weggelassen; jede Änderung daran berechnet es neu</translation>
    </message>
    <message>
        <source>the transfer vectors of this building do not fit into the graphics processor</source>
        <translation>die Transfervektoren dieses Gebäudes passen nicht in den Grafikprozessor</translation>
    </message>
</context>
<context>
    <name>soffit::ui::QualityPanel</name>
    <message>
        <source>Draft: quick to precompute</source>
        <translation>Entwurf: schnell vorberechnet</translation>
    </message>
    <message>
        <source>Interactive</source>
        <translation>Interaktiv</translation>
    </message>
    <message>
        <source>Final: finer, slower to update</source>
        <translation>Endfassung: feiner, langsamer</translation>
    </message>
    <message>
        <source>How finely light is precomputed. Another quality is precomputed in the background.</source>
        <translation>Wie fein das Licht vorberechnet wird. Eine andere Qualität wird im Hintergrund vorberechnet.</translation>
    </message>
    <message>
        <source>Last move of a luminaire</source>
        <translation>Letzte Bewegung einer Leuchte</translation>
    </message>
    <message>
        <source>Direct light</source>
        <translation>Direktes Licht</translation>
    </message>
    <message>
        <source>In closed form times visibility, at every point</source>
        <translation>Geschlossene Form mal Sichtbarkeit, an jedem Punkt</translation>
    </message>
    <message>
        <source>First reflection</source>
        <translation>Erste Reflexion</translation>
    </message>
    <message>
        <source>From every point, by precomputed rays</source>
        <translation>Von jedem Punkt, über vorberechnete Strahlen</translation>
    </message>
    <message>
        <source>All further reflections</source>
        <translation>Weitere Reflexionen</translation>
    </message>
    <message>
        <source>Solved to a residual, not counted in bounces</source>
        <translation>Bis auf ein Residuum gelöst, nicht in Reflexionen gezählt</translation>
    </message>
    <message>
        <source>Gathering them</source>
        <translation>Ihre Sammlung</translation>
    </message>
    <message>
        <source>From patches to where light differs</source>
        <translation>Von Flächenstücken dorthin, wo sich Licht unterscheidet</translation>
    </message>
    <message>
        <source>All points</source>
        <translation>Alle Punkte</translation>
    </message>
    <message>
        <source>Interpolated with precomputed weights</source>
        <translation>Mit vorberechneten Gewichten interpoliert</translation>
    </message>
    <message>
        <source>Together</source>
        <translation>Zusammen</translation>
    </message>
    <message>
        <source>Light transport</source>
        <translation>Lichttransport</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Where light is computed and sent on</source>
        <translation>Wo Licht berechnet und weitergegeben wird</translation>
    </message>
    <message>
        <source>Gather points</source>
        <translation>Sammelpunkte</translation>
    </message>
    <message>
        <source>Of these, where rays were traced for all the others</source>
        <translation>Davon: wo Strahlen für alle anderen verfolgt wurden</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Speicher</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Computed</source>
        <translation>Berechnet</translation>
    </message>
    <message>
        <source>Not needed here</source>
        <translation>Hier nicht benötigt</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>With the project&apos;s own %1</source>
        <translation>Mit eigenen Werten des Projekts: %1</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 MB</source>
        <translation>%1 MB</translation>
    </message>
    <message>
        <source>coarse, being refined</source>
        <translation>grob, wird verfeinert</translation>
    </message>
    <message>
        <source>complete</source>
        <translation>vollständig</translation>
    </message>
    <message>
        <source>Shadows of the last move</source>
        <translation>Schatten der letzten Bewegung</translation>
    </message>
    <message>
        <source>Rays traced</source>
        <translation>Verfolgte Strahlen</translation>
    </message>
    <message>
        <source>None: what hides a light is found from the shapes between it and the point, in closed form</source>
        <translation>Keine: was eine Leuchte verdeckt, folgt in geschlossener Form aus den Formen zwischen ihr und dem Punkt</translation>
    </message>
    <message>
        <source>Rays avoided</source>
        <translation>Gesparte Strahlen</translation>
    </message>
    <message>
        <source>That 64 shadow rays for each lit point would have taken</source>
        <translation>Die bei 64 Schattenstrahlen je beleuchtetem Punkt nötig wären</translation>
    </message>
    <message>
        <source>Points computed</source>
        <translation>Berechnete Punkte</translation>
    </message>
    <message>
        <source>The others lie behind the light, or it behind them</source>
        <translation>Die anderen liegen hinter der Leuchte oder sie hinter ihnen</translation>
    </message>
    <message>
        <source>Groups of points skipped</source>
        <translation>Übersprungene Punktgruppen</translation>
    </message>
    <message>
        <source>Turned away from the light as a whole</source>
        <translation>Als Ganzes von der Leuchte abgewandt</translation>
    </message>
    <message>
        <source>Groups that nothing can shade</source>
        <translation>Gruppen, die nichts verschatten kann</translation>
    </message>
    <message>
        <source>Empty between them and the light: no test at all</source>
        <translation>Zwischen ihnen und der Leuchte ist nichts: kein einziger Test</translation>
    </message>
    <message>
        <source>Light from outside</source>
        <translation>Licht von außen</translation>
    </message>
    <message>
        <source>Found exactly at rest; mixed from smooth skies while a slider is held</source>
        <translation>In Ruhe genau; aus glatten Himmeln gemischt, solange ein Regler gehalten wird</translation>
    </message>
    <message>
        <source>being computed</source>
        <translation>wird berechnet</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>Advanced…</source>
        <translation>Erweitert…</translation>
    </message>
    <message>
        <source>Every single setting, and the methods of the founding papers</source>
        <translation>Jede einzelne Einstellung und die Verfahren der Grundlagenarbeiten</translation>
    </message>
    <message>
        <source>Reflections</source>
        <translation>Spiegelungen</translation>
    </message>
    <message>
        <source>Pictures of the lit room from these places, made anew with every light</source>
        <translation>Bilder des beleuchteten Raums von diesen Stellen, mit jedem Licht neu</translation>
    </message>
    <message>
        <source>%1 places, %2 ms</source>
        <translation>%1 Stellen, %2 ms</translation>
    </message>
    <message>
        <source>Sky in hand</source>
        <translation>Himmel in der Hand</translation>
    </message>
    <message>
        <source>Memory of the graphics processor and time per step of the slider, where it adds up the light of the sky</source>
        <translation>Speicher des Grafikprozessors und Zeit je Schritt des Reglers, wo er das Licht des Himmels aufsummiert</translation>
    </message>
    <message>
        <source>by the processor</source>
        <translation>vom Prozessor</translation>
    </message>
    <message>
        <source>%1 MB, %2 ms</source>
        <translation>%1 MB, %2 ms</translation>
    </message>
    <message>
        <source>From point to point</source>
        <translation>Von Punkt zu Punkt</translation>
    </message>
    <message>
        <source>All reflections once more between all points, for what patches are too coarse for</source>
        <translation>Alle Reflexionen noch einmal zwischen allen Punkten, wofür Flächenstücke zu grob sind</translation>
    </message>
</context>
<context>
    <name>soffit::ui::QuantityBox</name>
    <message>
        <source>mixed</source>
        <translation>gemischt</translation>
    </message>
</context>
<context>
    <name>soffit::ui::RecoveryDialog</name>
    <message>
        <source>Unsaved work was found</source>
        <translation>Nicht gespeicherte Arbeit gefunden</translation>
    </message>
    <message>
        <source>Soffit did not end as it should. These versions were kept; the project files themselves are as you saved them last.</source>
        <translation>Soffit wurde nicht ordnungsgemäß beendet. Diese Fassungen wurden aufbewahrt; die Projektdateien selbst sind so, wie Sie sie zuletzt gespeichert haben.</translation>
    </message>
    <message>
        <source>Versions that were kept</source>
        <translation>Aufbewahrte Fassungen</translation>
    </message>
    <message>
        <source>%1
%2
%3</source>
        <translation>%1
%2
%3</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Später</translation>
    </message>
</context>
<context>
    <name>soffit::ui::RelightWorker</name>
    <message>
        <source>from the cache</source>
        <translation>aus dem Zwischenspeicher</translation>
    </message>
    <message>
        <source>Light transport %1: %2 points, %3 MB</source>
        <translation>Lichttransport %1: %2 Punkte, %3 MB</translation>
    </message>
    <message>
        <source>computed in %L1 s</source>
        <translation>in %L1 s berechnet</translation>
    </message>
</context>
<context>
    <name>soffit::ui::RestTracer</name>
    <message>
        <source>Ray tracing the view</source>
        <translation>Ansicht wird strahlverfolgt</translation>
    </message>
    <message>
        <source>There is not enough memory to trace the view</source>
        <translation>Der Speicher reicht nicht, um die Ansicht strahlzuverfolgen</translation>
    </message>
</context>
<context>
    <name>soffit::ui::ResultsModel</name>
    <message>
        <source>Base</source>
        <translation>Basis</translation>
    </message>
    <message numerus="yes">
        <source>%n luminaire(s) whose photometric file declares no power are left out</source>
        <translation>
            <numerusform>%n Leuchte, deren Photometriedatei keine Leistung nennt, ist nicht enthalten</numerusform>
            <numerusform>%n Leuchten, deren Photometriedateien keine Leistung nennen, sind nicht enthalten</numerusform>
        </translation>
    </message>
    <message>
        <source>Luminaires changed; the reading is under way</source>
        <translation>Leuchten wurden geändert; die Auswertung läuft</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Variante</translation>
    </message>
    <message>
        <source>Work plane</source>
        <translation>Nutzebene</translation>
    </message>
    <message>
        <source>U₀</source>
        <translation>U₀</translation>
    </message>
    <message>
        <source>Φ lm</source>
        <translation>Φ lm</translation>
    </message>
    <message>
        <source>lm/m²</source>
        <translation>lm/m²</translation>
    </message>
    <message>
        <source>P W</source>
        <translation>P W</translation>
    </message>
    <message>
        <source>W/m²</source>
        <translation>W/m²</translation>
    </message>
    <message>
        <source>The layout in the view is in bold</source>
        <translation>Die Variante in der Ansicht ist fett</translation>
    </message>
    <message>
        <source>The grid of points that is read</source>
        <translation>Das Raster der ausgewerteten Punkte</translation>
    </message>
    <message>
        <source>Mean illuminance (maintenance factor 1)</source>
        <translation>Mittlere Beleuchtungsstärke (Wartungsfaktor 1)</translation>
    </message>
    <message>
        <source>Least illuminance of all points</source>
        <translation>Kleinste Beleuchtungsstärke aller Punkte</translation>
    </message>
    <message>
        <source>Uniformity: least over mean</source>
        <translation>Gleichmäßigkeit: kleinste durch mittlere</translation>
    </message>
    <message>
        <source>Greatest illuminance of all points</source>
        <translation>Größte Beleuchtungsstärke aller Punkte</translation>
    </message>
    <message>
        <source>Luminous flux of what is on, as it is dimmed</source>
        <translation>Lichtstrom der eingeschalteten Leuchten, wie gedimmt</translation>
    </message>
    <message>
        <source>Luminous flux over the area of all work planes</source>
        <translation>Lichtstrom je Fläche aller Nutzebenen</translation>
    </message>
    <message>
        <source>Input power that the photometric files declare, times dimming</source>
        <translation>Anschlussleistung laut Photometriedateien, mal Dimmwert</translation>
    </message>
    <message>
        <source>Power over the area of all work planes</source>
        <translation>Leistung je Fläche aller Nutzebenen</translation>
    </message>
    <message>
        <source>Ēm %1</source>
        <translation>Ēm %1</translation>
    </message>
    <message>
        <source>Emin %1</source>
        <translation>Emin %1</translation>
    </message>
    <message>
        <source>Emax %1</source>
        <translation>Emax %1</translation>
    </message>
</context>
<context>
    <name>soffit::ui::ResultsPanel</name>
    <message>
        <source>Readings of the work planes</source>
        <translation>Ergebnisse der Nutzebenen</translation>
    </message>
    <message>
        <source>Two layouts compared</source>
        <translation>Zwei Varianten im Vergleich</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Differenzen</translation>
    </message>
    <message>
        <source>The two layouts that are compared, and what differs</source>
        <translation>Die beiden verglichenen Varianten und ihre Unterschiede</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>The table as text for a spreadsheet (Ctrl+C): the rows selected, or all</source>
        <translation>Die Tabelle als Text für eine Tabellenkalkulation (Strg+C): die ausgewählten Zeilen oder alle</translation>
    </message>
    <message>
        <source>Export CSV…</source>
        <translation>CSV exportieren…</translation>
    </message>
    <message>
        <source>The figures of all layouts, as soffit compare writes them</source>
        <translation>Die Zahlen aller Varianten, wie „soffit compare“ sie schreibt</translation>
    </message>
    <message>
        <source>No readings yet</source>
        <translation>Noch keine Ergebnisse</translation>
    </message>
    <message>
        <source>The project has no work planes: flux and power alone</source>
        <translation>Das Projekt hat keine Nutzebenen: nur Lichtstrom und Leistung</translation>
    </message>
    <message>
        <source>Preview: the light transport is still being computed</source>
        <translation>Vorschau: Der Lichttransport wird noch berechnet</translation>
    </message>
    <message>
        <source>Work planes of %1 m² in all</source>
        <translation>Nutzebenen mit insgesamt %1 m²</translation>
    </message>
</context>
<context>
    <name>soffit::ui::ShapeFields</name>
    <message>
        <source>along x</source>
        <translation>entlang x</translation>
    </message>
    <message>
        <source>along y</source>
        <translation>entlang y</translation>
    </message>
    <message>
        <source>length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Disk</source>
        <translation>Scheibe</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Tube</source>
        <translation>Röhre</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Polygon</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Mesh</translation>
    </message>
</context>
<context>
    <name>soffit::ui::ShapeText</name>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Rectangle %1 × %2</source>
        <translation>Rechteck %1 × %2</translation>
    </message>
    <message>
        <source>Disk ⌀ %1</source>
        <translation>Scheibe ⌀ %1</translation>
    </message>
    <message>
        <source>Sphere ⌀ %1</source>
        <translation>Kugel ⌀ %1</translation>
    </message>
    <message>
        <source>Tube %1, ⌀ %2</source>
        <translation>Röhre %1, ⌀ %2</translation>
    </message>
    <message>
        <source>Polygon, %1 corners</source>
        <translation>Polygon, %1 Ecken</translation>
    </message>
    <message>
        <source>Mesh %1</source>
        <translation>Mesh %1</translation>
    </message>
</context>
<context>
    <name>soffit::ui::SizePreview</name>
    <message>
        <source>%1 wide, %2 deep, %3 high</source>
        <translation>%1 breit, %2 tief, %3 hoch</translation>
    </message>
</context>
<context>
    <name>soffit::ui::StartPage</name>
    <message>
        <source>Recent projects</source>
        <translation>Zuletzt geöffnete Projekte</translation>
    </message>
    <message>
        <source>Projects that you open appear here.</source>
        <translation>Projekte, die Sie öffnen, erscheinen hier.</translation>
    </message>
    <message>
        <source>Sample projects</source>
        <translation>Beispielprojekte</translation>
    </message>
    <message>
        <source>Open a project…</source>
        <translation>Projekt öffnen…</translation>
    </message>
    <message>
        <source>Import a building…</source>
        <translation>Gebäude importieren…</translation>
    </message>
    <message>
        <source>A model as glTF, OBJ, IFC, FBX, Collada, 3DS, PLY or STL; it can also be dropped on this window</source>
        <translation>Ein Modell als glTF, OBJ, IFC, FBX, Collada, 3DS, PLY oder STL; es kann auch auf dieses Fenster gezogen werden</translation>
    </message>
    <message>
        <source>New project</source>
        <translation>Neues Projekt</translation>
    </message>
</context>
<context>
    <name>soffit::ui::StatusLine</name>
    <message>
        <source>Place under the cursor</source>
        <translation>Ort unter dem Zeiger</translation>
    </message>
    <message>
        <source>Illuminance of the surface under the cursor, and its diffuse luminance</source>
        <translation>Beleuchtungsstärke der Fläche unter dem Zeiger und ihre diffuse Leuchtdichte</translation>
    </message>
    <message>
        <source>State of the light; milliseconds of its last update and of the last picture</source>
        <translation>Zustand des Lichts; Millisekunden der letzten Aktualisierung und des letzten Bildes</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>, %1 s left</source>
        <translation>, noch %1 s</translation>
    </message>
    <message>
        <source>%1 · light %2 ms · picture %3 ms</source>
        <translation>%1 · Licht %2 ms · Bild %3 ms</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Converged</source>
        <translation>Konvergiert</translation>
    </message>
    <message>
        <source>The light that is shown was compared with the path tracer</source>
        <translation>Das gezeigte Licht wurde mit dem Pfadverfolger verglichen</translation>
    </message>
</context>
<context>
    <name>soffit::ui::Verification</name>
    <message>
        <source>The light changed while it was being verified: verify it again</source>
        <translation>Das Licht wurde während der Prüfung geändert: bitte erneut prüfen</translation>
    </message>
</context>
<context>
    <name>soffit::ui::VerifyPanel</name>
    <message>
        <source>Selected alone too</source>
        <translation>Auswahl auch allein</translation>
    </message>
    <message>
        <source>In the view</source>
        <translation>In der Ansicht</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Standard error of the reference at every point. Half of it takes four times as long.</source>
        <translation>Standardfehler der Referenz an jedem Punkt. Der halbe dauert viermal so lange.</translation>
    </message>
    <message>
        <source>Standard error of the reference</source>
        <translation>Standardfehler der Referenz</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>After this time what the reference has reached counts</source>
        <translation>Nach dieser Zeit gilt, was die Referenz erreicht hat</translation>
    </message>
    <message>
        <source>Time limit</source>
        <translation>Zeitgrenze</translation>
    </message>
    <message>
        <source>The light of the selected luminaire is checked apart from all others too, against its own mean</source>
        <translation>Das Licht der ausgewählten Leuchte wird auch getrennt von allen anderen geprüft, gegen seinen eigenen Mittelwert</translation>
    </message>
    <message>
        <source>A disc at every point: blue is too dark, orange too bright, hollow within twice the reference&apos;s own noise</source>
        <translation>Eine Scheibe an jedem Punkt: blau ist zu dunkel, orange zu hell, hohl innerhalb des doppelten Rauschens der Referenz</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>The figures as text for a spreadsheet</source>
        <translation>Die Werte als Text für eine Tabellenkalkulation</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Mean lx</source>
        <translation>Mittel lx</translation>
    </message>
    <message>
        <source>RMS %</source>
        <translation>RMS %</translation>
    </message>
    <message>
        <source>Bias %</source>
        <translation>Bias %</translation>
    </message>
    <message>
        <source>P95 %</source>
        <translation>P95 %</translation>
    </message>
    <message>
        <source>Noise %</source>
        <translation>Rauschen %</translation>
    </message>
    <message>
        <source>Points drawn from all lit surfaces, and the points of the work planes</source>
        <translation>Zufällige Punkte aller beleuchteten Flächen und die Punkte der Nutzebenen</translation>
    </message>
    <message>
        <source>Of the reference</source>
        <translation>Der Referenz</translation>
    </message>
    <message>
        <source>Root mean square error over the mean; the reference&apos;s noise is taken out</source>
        <translation>Quadratisches Mittel der Fehler, bezogen auf den Mittelwert; das Rauschen der Referenz ist abgezogen</translation>
    </message>
    <message>
        <source>Mean error over the mean; positive: computed values are too high</source>
        <translation>Mittlerer Fehler, bezogen auf den Mittelwert; positiv: die berechneten Werte sind zu hoch</translation>
    </message>
    <message>
        <source>95 % of the points are nearer than this, each relative to its own value (at least 5 % of the mean); the reference&apos;s noise included</source>
        <translation>95 % der Punkte liegen näher, jeder bezogen auf seinen eigenen Wert (mindestens 5 % des Mittelwerts); einschließlich des Rauschens der Referenz</translation>
    </message>
    <message>
        <source>Standard error of the reference over the mean</source>
        <translation>Standardfehler der Referenz, bezogen auf den Mittelwert</translation>
    </message>
    <message>
        <source>to</source>
        <translation>auf</translation>
    </message>
    <message>
        <source>within</source>
        <translation>in</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Traces paths until every point is known, and compares</source>
        <translation>Verfolgt Lichtwege, bis jeder Punkt bekannt ist, und vergleicht</translation>
    </message>
    <message>
        <source>Gives the verification up</source>
        <translation>Bricht die Prüfung ab</translation>
    </message>
    <message>
        <source>Waits for the final light…</source>
        <translation>Wartet auf das endgültige Licht…</translation>
    </message>
    <message>
        <source>The reference runs; work on, but any change of the light ends it</source>
        <translation>Die Referenz läuft; arbeiten Sie weiter, aber jede Änderung des Lichts beendet sie</translation>
    </message>
    <message>
        <source>Not verified yet. An independent path tracer computes the same light, and the two are compared.</source>
        <translation>Noch nicht geprüft. Ein unabhängiger Pfadverfolger berechnet dasselbe Licht, und beide werden verglichen.</translation>
    </message>
    <message>
        <source>%1 s, %2 million rays</source>
        <translation>%1 s, %2 Millionen Strahlen</translation>
    </message>
    <message>
        <source> The time ended before every point was known that well: see the noise.</source>
        <translation> Die Zeit endete, bevor jeder Punkt so genau bekannt war: siehe Rauschen.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Verified&lt;/b&gt;: the figures are of the light that is shown (%1).</source>
        <translation>&lt;b&gt;Geprüft&lt;/b&gt;: die Werte gelten für das gezeigte Licht (%1).</translation>
    </message>
    <message>
        <source>The light changed since: the figures are of an earlier state (%1).</source>
        <translation>Das Licht wurde seither geändert: die Werte gelten für einen früheren Stand (%1).</translation>
    </message>
    <message>
        <source>Work planes</source>
        <translation>Nutzebenen</translation>
    </message>
    <message>
        <source>All lit surfaces</source>
        <translation>Alle beleuchteten Flächen</translation>
    </message>
    <message>
        <source>%1 alone</source>
        <translation>%1 allein</translation>
    </message>
</context>
<context>
    <name>soffit::ui::ViewBar</name>
    <message>
        <source>What this view shows</source>
        <translation>Was diese Ansicht zeigt</translation>
    </message>
    <message>
        <source>Place of the cut</source>
        <translation>Lage des Schnitts</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>Cut at %1</source>
        <translation>Schnitt bei %1</translation>
    </message>
    <message>
        <source>Where the building is cut open; Ctrl and the wheel move it, too</source>
        <translation>Wo das Gebäude aufgeschnitten ist; Strg und das Rad verschieben es auch</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Variante</translation>
    </message>
    <message>
        <source>The one that is edited</source>
        <translation>Die bearbeitete</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Basis</translation>
    </message>
</context>
<context>
    <name>soffit::ui::ViewPanel</name>
    <message>
        <source>Exposure</source>
        <translation>Belichtung</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>Auto</translation>
    </message>
    <message>
        <source>Expose for what is seen now</source>
        <translation>Für das jetzt Sichtbare belichten</translation>
    </message>
    <message>
        <source>OpenColorIO view transform, the same in exported pictures</source>
        <translation>OpenColorIO-Ansichtstransformation, dieselbe wie in exportierten Bildern</translation>
    </message>
    <message>
        <source>False colours of illuminance</source>
        <translation>Falschfarben der Beleuchtungsstärke</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>View transform</source>
        <translation>Ansichtstransformation</translation>
    </message>
    <message>
        <source>Isolux lines</source>
        <translation>Isoluxlinien</translation>
    </message>
    <message>
        <source>on surfaces</source>
        <translation>auf Flächen</translation>
    </message>
    <message>
        <source>on work planes</source>
        <translation>auf Nutzebenen</translation>
    </message>
    <message>
        <source>on both</source>
        <translation>auf beiden</translation>
    </message>
    <message>
        <source>Where isolux lines are drawn</source>
        <translation>Wo Isoluxlinien gezeichnet werden</translation>
    </message>
    <message>
        <source>Values on work planes</source>
        <translation>Werte auf Nutzebenen</translation>
    </message>
    <message>
        <source>A number at each point that there is room for</source>
        <translation>Eine Zahl an jedem Punkt, für den Platz ist</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Weiß</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Look</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Anzeige</translation>
    </message>
    <message>
        <source>OpenColorIO look, on top of the view</source>
        <translation>Look von OpenColorIO, zusätzlich zur Ansicht</translation>
    </message>
    <message>
        <source>What the picture is shown on: code values are made for this device</source>
        <translation>Worauf das Bild gezeigt wird: Die Codewerte gelten für dieses Gerät</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keiner</translation>
    </message>
    <message>
        <source>White balance</source>
        <translation>Weißabgleich</translation>
    </message>
</context>
<context>
    <name>soffit::ui::WhiteFields</name>
    <message>
        <source>Daylight</source>
        <translation>Tageslicht</translation>
    </message>
    <message>
        <source>White balance: the colour of light that looks white, as eyes and cameras adapt to it</source>
        <translation>Weißabgleich: die Lichtfarbe, die weiß aussieht, wie sich Augen und Kameras an sie anpassen</translation>
    </message>
    <message>
        <source>White balance</source>
        <translation>Weißabgleich</translation>
    </message>
    <message>
        <source>Colour temperature that looks white</source>
        <translation>Farbtemperatur, die weiß aussieht</translation>
    </message>
    <message>
        <source>Luminaires</source>
        <translation>Leuchten</translation>
    </message>
    <message>
        <source>Kelvin</source>
        <translation>Kelvin</translation>
    </message>
</context>
</TS>
