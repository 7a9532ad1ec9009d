# Third-party libraries. Each room of the core links only what design rules let it use.
find_package(Eigen3 CONFIG REQUIRED)  # CONFIG: CGAL brings a FindEigen3 without the target
find_package(nlohmann_json REQUIRED)
find_package(OpenMesh REQUIRED)
find_package(CGAL REQUIRED)
find_package(SQLite3 REQUIRED)
find_package(Qt6 REQUIRED COMPONENTS Core Gui)
if(EDGEWRIGHT_UI)
    find_package(Qt6 REQUIRED COMPONENTS Widgets OpenGL OpenGLWidgets Svg LinguistTools)
    find_package(VTK REQUIRED COMPONENTS CommonCore CommonDataModel CommonTransforms
        FiltersCore FiltersSources FiltersHybrid IOImage InteractionStyle RenderingCore
        RenderingOpenGL2 RenderingAnnotation RenderingFreeType)
endif()
