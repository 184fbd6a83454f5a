# What makes random sessions: compiled once for all who run them.
include_guard(GLOBAL)
add_library(random_session STATIC ${CMAKE_CURRENT_LIST_DIR}/random_session.cpp)
batten_settings(random_session)
target_include_directories(random_session PUBLIC ${PROJECT_SOURCE_DIR})
target_compile_definitions(random_session PRIVATE BATTEN_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/data")
target_link_libraries(random_session PUBLIC batten_editor batten_core)
