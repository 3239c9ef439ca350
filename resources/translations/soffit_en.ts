<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>DragSession</name>
    <message numerus="yes">
        <source>Copy %n luminaires</source>
        <translation>
            <numerusform>Copy %n luminaire</numerusform>
            <numerusform>Copy %n luminaires</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Rotate %n luminaires</source>
        <translation>
            <numerusform>Rotate %n luminaire</numerusform>
            <numerusform>Rotate %n luminaires</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Resize %n luminaires</source>
        <translation>
            <numerusform>Resize %n luminaire</numerusform>
            <numerusform>Resize %n luminaires</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move %n luminaires</source>
        <translation>
            <numerusform>Move %n luminaire</numerusform>
            <numerusform>Move %n luminaires</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>soffit::ui::Arraying</name>
    <message numerus="yes">
        <source>Array of %n luminaires</source>
        <translation>
            <numerusform>Array of %n luminaire</numerusform>
            <numerusform>Array of %n luminaires</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>soffit::ui::HelpWindow</name>
    <message numerus="yes">
        <source>On %n page(s)</source>
        <translation>
            <numerusform>On %n page</numerusform>
            <numerusform>On %n pages</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>soffit::ui::LibraryPanel</name>
    <message numerus="yes">
        <source>%n files could not be read</source>
        <translation>
            <numerusform>%n file could not be read</numerusform>
            <numerusform>%n files could not be read</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>soffit::ui::LuminairePanel</name>
    <message numerus="yes">
        <source>%n luminaires</source>
        <translation>
            <numerusform>%n luminaire</numerusform>
            <numerusform>%n luminaires</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>soffit::ui::PictureDialog</name>
    <message numerus="yes">
        <source>%n picture(s)</source>
        <translation>
            <numerusform>%n picture</numerusform>
            <numerusform>%n pictures</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>soffit::ui::ResultsModel</name>
    <message numerus="yes">
        <source>%n luminaire(s) whose photometric file declares no power are left out</source>
        <translation>
            <numerusform>%n luminaire whose photometric file declares no power is left out</numerusform>
            <numerusform>%n luminaires whose photometric files declare no power are left out</numerusform>
        </translation>
    </message>
</context>
</TS>
