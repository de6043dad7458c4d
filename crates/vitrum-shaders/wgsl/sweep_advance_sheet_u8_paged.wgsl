struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
}
struct type_6 {
member: array<f32>,
}
struct type_11 {
member: array<u32>,
}
struct type_13 {
member: type_4,
member_1: type_4,
member_2: type_4,
member_3: type_4,
member_4: type_4,
member_5: vec4<i32>,
member_6: vec4<i32>,
member_7: vec4<i32>,
}
struct type_14 {
member: vec4<u32>,
member_1: vec4<u32>,
member_2: vec4<u32>,
member_3: vec4<u32>,
member_4: type_4,
member_5: type_13,
member_6: type_13,
member_7: type_4,
member_8: type_4,
member_9: type_4,
member_10: type_4,
member_11: type_4,
member_12: type_4,
member_13: type_4,
member_14: type_4,
member_15: type_4,
member_16: type_4,
member_17: type_4,
member_18: type_4,
member_19: type_4,
member_20: type_4,
member_21: type_4,
member_22: type_4,
member_23: type_4,
member_24: type_4,
member_25: vec4<u32>,
member_26: type_4,
member_27: type_4,
member_28: type_4,
member_29: type_4,
member_30: type_4,
member_31: type_4,
}
struct type_15 {
member: type_14,
}
struct type_18 {
member: array<i32, 4>,
member_1: array<u32, 6>,
}
struct type_19 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
}
struct type_20 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: vec3<f32>,
}
struct type_21 {
member: f32,
member_1: f32,
member_2: f32,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_15;
@group(0) @binding(1)
var<storage> global_2: type_11;
@group(0) @binding(3)
var<storage> global_3: type_11;
@group(0) @binding(4)
var<storage> global_4: type_11;
@group(0) @binding(5)
var<storage> global_5: type_6;
@group(0) @binding(6)
var<storage, read_write> global_6: type_6;
fn function_() {
var local: type_18;
var local_1: vec3<f32>;
var local_2: type_18;
var local_3: vec3<f32>;
var local_4: type_18;
var local_5: vec3<f32>;
var phi_5836_: type_19;
var phi_7157_: type_20;
var phi_8679_: type_21;
var phi_9703_: f32;
var phi_9704_: f32;
var phi_9705_: f32;
var phi_9706_: bool;
switch bitcast<i32>(0u) {
default: {
let _e91 = global;
let _e94 = arrayLength((&global_2.member));
let _e98 = arrayLength((&global_4.member));
let _e105 = global_1.member.member_1;
let _e108 = (_e91.x + _e105.x);
let _e111 = (_e91.y + _e105.y);
if (_e108 < _e105.z) {
if (_e111 < _e105.w) {
let _e119 = global_1.member.member[0u];
let _e123 = global_1.member.member[1u];
let _e124 = (_e119 * _e123);
let _e126 = ((_e111 * _e119) + _e108);
let _e127 = bitcast<i32>(_e126);
let _e129 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e131 = select(_e129, _e127, (_e127 < _e129));
let _e137 = global_6.member[bitcast<u32>(select(0i, _e131, (_e131 > 0i)))];
let _e138 = (_e124 + _e126);
let _e139 = bitcast<i32>(_e138);
let _e141 = select(_e129, _e139, (_e139 < _e129));
let _e147 = global_6.member[bitcast<u32>(select(0i, _e141, (_e141 > 0i)))];
let _e149 = ((2u * _e124) + _e126);
let _e150 = bitcast<i32>(_e149);
let _e152 = select(_e129, _e150, (_e150 < _e129));
let _e158 = global_6.member[bitcast<u32>(select(0i, _e152, (_e152 > 0i)))];
let _e160 = ((3u * _e124) + _e126);
let _e161 = bitcast<i32>(_e160);
let _e163 = select(_e129, _e161, (_e161 < _e129));
let _e169 = global_6.member[bitcast<u32>(select(0i, _e163, (_e163 > 0i)))];
let _e171 = ((4u * _e124) + _e126);
let _e172 = bitcast<i32>(_e171);
let _e174 = select(_e129, _e172, (_e172 < _e129));
let _e180 = global_6.member[bitcast<u32>(select(0i, _e174, (_e174 > 0i)))];
let _e182 = ((5u * _e124) + _e126);
let _e183 = bitcast<i32>(_e182);
let _e185 = select(_e129, _e183, (_e183 < _e129));
let _e191 = global_6.member[bitcast<u32>(select(0i, _e185, (_e185 > 0i)))];
let _e193 = ((6u * _e124) + _e126);
let _e194 = bitcast<i32>(_e193);
let _e196 = select(_e129, _e194, (_e194 < _e129));
let _e202 = global_6.member[bitcast<u32>(select(0i, _e196, (_e196 > 0i)))];
let _e204 = ((7u * _e124) + _e126);
let _e205 = bitcast<i32>(_e204);
let _e207 = select(_e129, _e205, (_e205 < _e129));
let _e213 = global_6.member[bitcast<u32>(select(0i, _e207, (_e207 > 0i)))];
let _e215 = ((8u * _e124) + _e126);
let _e216 = bitcast<i32>(_e215);
let _e218 = select(_e129, _e216, (_e216 < _e129));
let _e224 = global_6.member[bitcast<u32>(select(0i, _e218, (_e218 > 0i)))];
let _e226 = ((9u * _e124) + _e126);
let _e227 = bitcast<i32>(_e226);
let _e229 = select(_e129, _e227, (_e227 < _e129));
let _e235 = global_6.member[bitcast<u32>(select(0i, _e229, (_e229 > 0i)))];
let _e237 = ((10u * _e124) + _e126);
let _e238 = bitcast<i32>(_e237);
let _e240 = select(_e129, _e238, (_e238 < _e129));
let _e246 = global_6.member[bitcast<u32>(select(0i, _e240, (_e240 > 0i)))];
let _e250 = global_1.member.member_4.member_2;
let _e253 = (1f / select(1e-6f, _e202, (_e202 > 1e-6f)));
let _e257 = global_1.member.member_7.member_3;
let _e258 = (_e250 * _e257);
let _e263 = global_1.member.member_8.member;
let _e265 = (((_e180 * _e253) - _e263) * _e258);
let _e270 = global_1.member.member_8.member_1;
let _e272 = (((_e191 * _e253) - _e270) * _e258);
let _e276 = ((f32(bitcast<i32>(_e108)) - 0.5f) + _e137);
let _e280 = global_1.member.member_2[3u];
let _e281 = (_e280 + 1u);
let _e283 = select(1u, _e281, (_e281 > 0u));
let _e284 = (_e283 == 0u);
if _e284 {
break;
}
let _e289 = ((f32(bitcast<i32>((_e111 % _e283))) - 0.5f) + _e147);
let _e293 = global_1.member.member_4.member;
let _e297 = global_1.member.member_8.member_2;
let _e298 = (_e293 - _e297);
let _e302 = global_1.member.member_7.member;
let _e309 = global_1.member.member_7.member_2;
let _e311 = ((_e302 + (_e263 * _e298)) + ((_e276 + 0.5f) * _e309));
let _e315 = global_1.member.member_7.member_1;
let _e320 = ((_e315 + (_e270 * _e298)) + ((_e289 + 0.5f) * _e309));
let _e326 = global_1.member.member_4.member_1;
let _e327 = (_e326 - _e297);
let _e332 = ((_e302 + (_e263 * _e327)) + (((_e276 + _e265) + 0.5f) * _e309));
let _e337 = ((_e315 + (_e270 * _e327)) + (((_e289 + _e272) + 0.5f) * _e309));
if _e284 {
break;
}
let _e340 = bitcast<i32>(((_e111 / _e283) * 3u));
let _e342 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e344 = select(_e342, _e340, (_e340 < _e342));
let _e350 = global_5.member[bitcast<u32>(select(0i, _e344, (_e344 > 0i)))];
let _e351 = (_e340 + 1i);
let _e353 = select(_e342, _e351, (_e351 < _e342));
let _e359 = global_5.member[bitcast<u32>(select(0i, _e353, (_e353 > 0i)))];
let _e360 = (_e340 + 2i);
let _e362 = select(_e342, _e360, (_e360 < _e342));
let _e368 = global_5.member[bitcast<u32>(select(0i, _e362, (_e362 > 0i)))];
let _e371 = (1f / select(1e-6f, _e368, (_e368 > 1e-6f)));
let _e374 = (((_e350 * _e371) - _e263) * _e258);
let _e377 = (((_e359 * _e371) - _e270) * _e258);
let _e389 = global_1.member.member_5.member;
let _e402 = global_1.member.member_5.member.member_3;
let _e403 = ((((_e389.member * _e311) + (_e389.member_1 * _e320)) + (_e389.member_2 * _e293)) + _e402);
let _e407 = global_1.member.member_5.member_1;
let _e420 = global_1.member.member_5.member_1.member_3;
let _e421 = ((((_e407.member * _e311) + (_e407.member_1 * _e320)) + (_e407.member_2 * _e293)) + _e420);
let _e425 = global_1.member.member_5.member_2;
let _e438 = global_1.member.member_5.member_2.member_3;
let _e439 = ((((_e425.member * _e311) + (_e425.member_1 * _e320)) + (_e425.member_2 * _e293)) + _e438);
let _e445 = ((((_e389.member * _e332) + (_e389.member_1 * _e337)) + (_e389.member_2 * _e326)) + _e402);
let _e451 = ((((_e407.member * _e332) + (_e407.member_1 * _e337)) + (_e407.member_2 * _e326)) + _e420);
let _e457 = ((((_e425.member * _e332) + (_e425.member_1 * _e337)) + (_e425.member_2 * _e326)) + _e438);
let _e462 = global_1.member.member_5.member_3.member_3;
let _e467 = global_1.member.member_5.member_3.member;
let _e468 = (_e467 - 0.5f);
let _e470 = select(-0.5f, _e445, (_e445 > -0.5f));
let _e472 = select(_e468, _e470, (_e470 < _e468));
let _e477 = global_1.member.member_5.member_3.member_1;
let _e478 = (_e477 - 0.5f);
let _e480 = select(-0.5f, _e451, (_e451 > -0.5f));
let _e482 = select(_e478, _e480, (_e480 < _e478));
let _e487 = global_1.member.member_5.member_3.member_2;
let _e488 = (_e487 - 0.5f);
let _e490 = select(-0.5f, _e457, (_e457 > -0.5f));
let _e492 = select(_e488, _e490, (_e490 < _e488));
let _e493 = (_e445 - _e403);
let _e494 = (_e451 - _e421);
let _e495 = (_e457 - _e439);
let _e498 = bitcast<f32>((bitcast<u32>(_e493) & 2147483647u));
let _e501 = bitcast<f32>((bitcast<u32>(_e494) & 2147483647u));
let _e503 = select(_e501, _e498, (_e498 > _e501));
let _e506 = bitcast<f32>((bitcast<u32>(_e495) & 2147483647u));
let _e515 = bitcast<f32>((bitcast<u32>((_e445 - _e472)) & 2147483647u));
let _e518 = bitcast<f32>((bitcast<u32>((_e451 - _e482)) & 2147483647u));
let _e520 = select(_e518, _e515, (_e515 > _e518));
let _e523 = bitcast<f32>((bitcast<u32>((_e457 - _e492)) & 2147483647u));
let _e527 = (_e472 + 0.5f);
let _e528 = (_e467 - 1f);
let _e530 = select(0f, _e527, (_e527 > 0f));
let _e532 = select(_e528, _e530, (_e530 < _e528));
let _e539 = select(0i, select(select(i32(_e532), i32(-2147483648), (_e532 < -2147483600f)), 2147483647i, (_e532 > 2147483500f)), (_e532 == _e532));
let _e548 = global_1.member.member_5.member_7[3u];
let _e549 = (_e548 & 31i);
let _e552 = (_e482 + 0.5f);
let _e553 = (_e477 - 1f);
let _e555 = select(0f, _e552, (_e552 > 0f));
let _e557 = select(_e553, _e555, (_e555 < _e553));
let _e564 = select(0i, select(select(i32(_e557), i32(-2147483648), (_e557 < -2147483600f)), 2147483647i, (_e557 > 2147483500f)), (_e557 == _e557));
let _e571 = (_e492 + 0.5f);
let _e572 = (_e487 - 1f);
let _e574 = select(0f, _e571, (_e571 > 0f));
let _e576 = select(_e572, _e574, (_e574 < _e572));
let _e583 = select(0i, select(select(i32(_e576), i32(-2147483648), (_e576 < -2147483600f)), 2147483647i, (_e576 > 2147483500f)), (_e576 == _e576));
let _e594 = global_1.member.member_5.member_6[3u];
let _e600 = global_1.member.member_5.member_6[0u];
let _e605 = global_1.member.member_5.member_6[1u];
let _e609 = ((_e594 + ((_e539 - select(0i, 1i, (_e532 < f32(_e539)))) >> bitcast<u32>(_e549))) + (_e600 * (((_e564 - select(0i, 1i, (_e557 < f32(_e564)))) >> bitcast<u32>(_e549)) + (_e605 * ((_e583 - select(0i, 1i, (_e576 < f32(_e583)))) >> bitcast<u32>(_e549))))));
let _e611 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e613 = select(_e611, _e609, (_e609 < _e611));
let _e619 = global_3.member[bitcast<u32>(select(0i, _e613, (_e613 > 0i)))];
let _e626 = global_1.member.member[3u];
let _e633 = (((_e626 & 64u) != 0u) || ((((select(_e506, _e503, (_e503 > _e506)) <= _e462) && ((select(_e523, _e520, (_e520 > _e523)) > _e462) || (_e619 != 0u))) && true) && ((_e626 & 32u) != 0u)));
if (select(0u, select(7u, select(3u, 1u, ((((_e265 == 0f) && (_e272 == 0f)) && (_e374 == 0f)) && (_e377 == 0f))), _e633), (_e246 == 0f)) > 1u) {
let _e641 = global_1.member.member[2u];
if _e284 {
break;
}
if _e284 {
break;
}
let _e643 = (_e641 == 2u);
let _e646 = (((_e641 == 1u) || _e643) || (_e641 == 5u));
if _e646 {
let _e1000 = select(-1f, _e472, (_e472 > -1f));
let _e1002 = select(_e467, _e1000, (_e1000 < _e467));
let _e1009 = select(0i, select(select(i32(_e1002), i32(-2147483648), (_e1002 < -2147483600f)), 2147483647i, (_e1002 > 2147483500f)), (_e1002 == _e1002));
let _e1013 = (_e1009 - select(0i, 1i, (_e1002 < f32(_e1009))));
let _e1015 = select(-1f, _e482, (_e482 > -1f));
let _e1017 = select(_e477, _e1015, (_e1015 < _e477));
let _e1024 = select(0i, select(select(i32(_e1017), i32(-2147483648), (_e1017 < -2147483600f)), 2147483647i, (_e1017 > 2147483500f)), (_e1017 == _e1017));
let _e1028 = (_e1024 - select(0i, 1i, (_e1017 < f32(_e1024))));
let _e1030 = select(-1f, _e492, (_e492 > -1f));
let _e1032 = select(_e487, _e1030, (_e1030 < _e487));
let _e1039 = select(0i, select(select(i32(_e1032), i32(-2147483648), (_e1032 < -2147483600f)), 2147483647i, (_e1032 > 2147483500f)), (_e1032 == _e1032));
let _e1043 = (_e1039 - select(0i, 1i, (_e1032 < f32(_e1039))));
let _e1048 = global_1.member.member_5.member_5[0u];
let _e1053 = global_1.member.member_5.member_5[1u];
let _e1054 = (_e1013 + 1i);
let _e1055 = (_e1028 + 1i);
let _e1056 = (_e1043 + 1i);
let _e1063 = global_1.member.member_5.member_7[0u];
let _e1070 = global_1.member.member_5.member_7[1u];
let _e1076 = ((_e1054 >> bitcast<u32>(4i)) + (_e1063 * ((_e1055 >> bitcast<u32>(4i)) + (_e1070 * (_e1056 >> bitcast<u32>(4i))))));
let _e1078 = (bitcast<i32>(_e94) - 1i);
let _e1080 = select(_e1078, _e1076, (_e1076 < _e1078));
let _e1086 = global_2.member[bitcast<u32>(select(0i, _e1080, (_e1080 > 0i)))];
let _e1088 = (_e1054 & 15i);
let _e1091 = ((_e1055 & 15i) * _e1048);
let _e1093 = (bitcast<i32>(_e1086) + ((_e1056 & 15i) * _e1053));
let _e1094 = (_e1091 + _e1048);
let _e1096 = (_e1091 + (2i * _e1048));
let _e1098 = (_e1091 + (3i * _e1048));
let _e1099 = (_e1093 + _e1053);
let _e1101 = (_e1093 + (2i * _e1053));
let _e1103 = (_e1093 + (3i * _e1053));
local_4 = type_18(array<i32, 4>(_e1088, _e1088, _e1088, _e1088), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_5 = vec3<f32>((_e472 - f32(_e1013)), (_e482 - f32(_e1028)), (_e492 - f32(_e1043)));
let _e1117 = local_4.member[0u];
let _e1118 = ((_e1099 + _e1094) + _e1117);
let _e1120 = (_e1118 >> bitcast<u32>(2i));
let _e1123 = bitcast<u32>(((_e1118 & 3i) * 8i));
let _e1125 = select(_e1078, _e1120, (_e1120 < _e1078));
let _e1130 = global_2.member[bitcast<u32>(select(0i, _e1125, (_e1125 > 0i)))];
let _e1134 = (_e1120 + 1i);
let _e1136 = select(_e1078, _e1134, (_e1134 < _e1078));
let _e1141 = global_2.member[bitcast<u32>(select(0i, _e1136, (_e1136 > 0i)))];
let _e1148 = ((_e1130 >> bitcast<u32>((_e1123 & 31u))) | ((_e1141 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1123) & 31u))));
let _e1151 = local_4.member_1[0u];
let _e1157 = f32(bitcast<i32>(((_e1148 >> bitcast<u32>((_e1151 & 31u))) & 255u)));
let _e1160 = local_4.member_1[1u];
let _e1166 = f32(bitcast<i32>(((_e1148 >> bitcast<u32>((_e1160 & 31u))) & 255u)));
let _e1169 = local_4.member_1[2u];
let _e1175 = f32(bitcast<i32>(((_e1148 >> bitcast<u32>((_e1169 & 31u))) & 255u)));
let _e1178 = local_4.member_1[3u];
let _e1185 = local_5[0u];
let _e1188 = (_e1157 + ((_e1166 - _e1157) * _e1185));
let _e1189 = local_5[0u];
let _e1192 = (_e1166 + ((_e1175 - _e1166) * _e1189));
let _e1193 = local_5[0u];
let _e1196 = (_e1175 + ((f32(bitcast<i32>(((_e1148 >> bitcast<u32>((_e1178 & 31u))) & 255u))) - _e1175) * _e1193));
let _e1198 = local_4.member[0u];
let _e1199 = ((_e1099 + _e1096) + _e1198);
let _e1201 = (_e1199 >> bitcast<u32>(2i));
let _e1204 = bitcast<u32>(((_e1199 & 3i) * 8i));
let _e1206 = select(_e1078, _e1201, (_e1201 < _e1078));
let _e1211 = global_2.member[bitcast<u32>(select(0i, _e1206, (_e1206 > 0i)))];
let _e1215 = (_e1201 + 1i);
let _e1217 = select(_e1078, _e1215, (_e1215 < _e1078));
let _e1222 = global_2.member[bitcast<u32>(select(0i, _e1217, (_e1217 > 0i)))];
let _e1229 = ((_e1211 >> bitcast<u32>((_e1204 & 31u))) | ((_e1222 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1204) & 31u))));
let _e1230 = local_4.member_1[0u];
let _e1236 = f32(bitcast<i32>(((_e1229 >> bitcast<u32>((_e1230 & 31u))) & 255u)));
let _e1237 = local_4.member_1[1u];
let _e1243 = f32(bitcast<i32>(((_e1229 >> bitcast<u32>((_e1237 & 31u))) & 255u)));
let _e1244 = local_4.member_1[2u];
let _e1250 = f32(bitcast<i32>(((_e1229 >> bitcast<u32>((_e1244 & 31u))) & 255u)));
let _e1251 = local_4.member_1[3u];
let _e1258 = local_5[0u];
let _e1262 = local_5[0u];
let _e1265 = (_e1243 + ((_e1250 - _e1243) * _e1262));
let _e1266 = local_5[0u];
let _e1271 = local_4.member[0u];
let _e1272 = ((_e1101 + _e1094) + _e1271);
let _e1274 = (_e1272 >> bitcast<u32>(2i));
let _e1277 = bitcast<u32>(((_e1272 & 3i) * 8i));
let _e1279 = select(_e1078, _e1274, (_e1274 < _e1078));
let _e1284 = global_2.member[bitcast<u32>(select(0i, _e1279, (_e1279 > 0i)))];
let _e1288 = (_e1274 + 1i);
let _e1290 = select(_e1078, _e1288, (_e1288 < _e1078));
let _e1295 = global_2.member[bitcast<u32>(select(0i, _e1290, (_e1290 > 0i)))];
let _e1302 = ((_e1284 >> bitcast<u32>((_e1277 & 31u))) | ((_e1295 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1277) & 31u))));
let _e1303 = local_4.member_1[0u];
let _e1309 = f32(bitcast<i32>(((_e1302 >> bitcast<u32>((_e1303 & 31u))) & 255u)));
let _e1310 = local_4.member_1[1u];
let _e1316 = f32(bitcast<i32>(((_e1302 >> bitcast<u32>((_e1310 & 31u))) & 255u)));
let _e1317 = local_4.member_1[2u];
let _e1323 = f32(bitcast<i32>(((_e1302 >> bitcast<u32>((_e1317 & 31u))) & 255u)));
let _e1324 = local_4.member_1[3u];
let _e1331 = local_5[0u];
let _e1334 = (_e1309 + ((_e1316 - _e1309) * _e1331));
let _e1335 = local_5[0u];
let _e1338 = (_e1316 + ((_e1323 - _e1316) * _e1335));
let _e1339 = local_5[0u];
let _e1342 = (_e1323 + ((f32(bitcast<i32>(((_e1302 >> bitcast<u32>((_e1324 & 31u))) & 255u))) - _e1323) * _e1339));
let _e1344 = local_4.member[0u];
let _e1345 = ((_e1101 + _e1096) + _e1344);
let _e1347 = (_e1345 >> bitcast<u32>(2i));
let _e1350 = bitcast<u32>(((_e1345 & 3i) * 8i));
let _e1352 = select(_e1078, _e1347, (_e1347 < _e1078));
let _e1357 = global_2.member[bitcast<u32>(select(0i, _e1352, (_e1352 > 0i)))];
let _e1361 = (_e1347 + 1i);
let _e1363 = select(_e1078, _e1361, (_e1361 < _e1078));
let _e1368 = global_2.member[bitcast<u32>(select(0i, _e1363, (_e1363 > 0i)))];
let _e1375 = ((_e1357 >> bitcast<u32>((_e1350 & 31u))) | ((_e1368 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1350) & 31u))));
let _e1376 = local_4.member_1[0u];
let _e1382 = f32(bitcast<i32>(((_e1375 >> bitcast<u32>((_e1376 & 31u))) & 255u)));
let _e1383 = local_4.member_1[1u];
let _e1389 = f32(bitcast<i32>(((_e1375 >> bitcast<u32>((_e1383 & 31u))) & 255u)));
let _e1390 = local_4.member_1[2u];
let _e1396 = f32(bitcast<i32>(((_e1375 >> bitcast<u32>((_e1390 & 31u))) & 255u)));
let _e1397 = local_4.member_1[3u];
let _e1404 = local_5[0u];
let _e1408 = local_5[0u];
let _e1411 = (_e1389 + ((_e1396 - _e1389) * _e1408));
let _e1412 = local_5[0u];
let _e1417 = local_4.member[0u];
let _e1418 = ((_e1099 + _e1091) + _e1417);
let _e1420 = (_e1418 >> bitcast<u32>(2i));
let _e1423 = bitcast<u32>(((_e1418 & 3i) * 8i));
let _e1425 = select(_e1078, _e1420, (_e1420 < _e1078));
let _e1430 = global_2.member[bitcast<u32>(select(0i, _e1425, (_e1425 > 0i)))];
let _e1434 = (_e1420 + 1i);
let _e1436 = select(_e1078, _e1434, (_e1434 < _e1078));
let _e1441 = global_2.member[bitcast<u32>(select(0i, _e1436, (_e1436 > 0i)))];
let _e1448 = ((_e1430 >> bitcast<u32>((_e1423 & 31u))) | ((_e1441 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1423) & 31u))));
let _e1449 = local_4.member_1[1u];
let _e1455 = f32(bitcast<i32>(((_e1448 >> bitcast<u32>((_e1449 & 31u))) & 255u)));
let _e1456 = local_4.member_1[2u];
let _e1463 = local_5[0u];
let _e1466 = (_e1455 + ((f32(bitcast<i32>(((_e1448 >> bitcast<u32>((_e1456 & 31u))) & 255u))) - _e1455) * _e1463));
let _e1468 = local_4.member[0u];
let _e1469 = ((_e1099 + _e1098) + _e1468);
let _e1471 = (_e1469 >> bitcast<u32>(2i));
let _e1474 = bitcast<u32>(((_e1469 & 3i) * 8i));
let _e1476 = select(_e1078, _e1471, (_e1471 < _e1078));
let _e1481 = global_2.member[bitcast<u32>(select(0i, _e1476, (_e1476 > 0i)))];
let _e1485 = (_e1471 + 1i);
let _e1487 = select(_e1078, _e1485, (_e1485 < _e1078));
let _e1492 = global_2.member[bitcast<u32>(select(0i, _e1487, (_e1487 > 0i)))];
let _e1499 = ((_e1481 >> bitcast<u32>((_e1474 & 31u))) | ((_e1492 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1474) & 31u))));
let _e1500 = local_4.member_1[1u];
let _e1506 = f32(bitcast<i32>(((_e1499 >> bitcast<u32>((_e1500 & 31u))) & 255u)));
let _e1507 = local_4.member_1[2u];
let _e1514 = local_5[0u];
let _e1519 = local_4.member[0u];
let _e1520 = ((_e1101 + _e1091) + _e1519);
let _e1522 = (_e1520 >> bitcast<u32>(2i));
let _e1525 = bitcast<u32>(((_e1520 & 3i) * 8i));
let _e1527 = select(_e1078, _e1522, (_e1522 < _e1078));
let _e1532 = global_2.member[bitcast<u32>(select(0i, _e1527, (_e1527 > 0i)))];
let _e1536 = (_e1522 + 1i);
let _e1538 = select(_e1078, _e1536, (_e1536 < _e1078));
let _e1543 = global_2.member[bitcast<u32>(select(0i, _e1538, (_e1538 > 0i)))];
let _e1550 = ((_e1532 >> bitcast<u32>((_e1525 & 31u))) | ((_e1543 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1525) & 31u))));
let _e1551 = local_4.member_1[1u];
let _e1557 = f32(bitcast<i32>(((_e1550 >> bitcast<u32>((_e1551 & 31u))) & 255u)));
let _e1558 = local_4.member_1[2u];
let _e1565 = local_5[0u];
let _e1568 = (_e1557 + ((f32(bitcast<i32>(((_e1550 >> bitcast<u32>((_e1558 & 31u))) & 255u))) - _e1557) * _e1565));
let _e1570 = local_4.member[0u];
let _e1571 = ((_e1101 + _e1098) + _e1570);
let _e1573 = (_e1571 >> bitcast<u32>(2i));
let _e1576 = bitcast<u32>(((_e1571 & 3i) * 8i));
let _e1578 = select(_e1078, _e1573, (_e1573 < _e1078));
let _e1583 = global_2.member[bitcast<u32>(select(0i, _e1578, (_e1578 > 0i)))];
let _e1587 = (_e1573 + 1i);
let _e1589 = select(_e1078, _e1587, (_e1587 < _e1078));
let _e1594 = global_2.member[bitcast<u32>(select(0i, _e1589, (_e1589 > 0i)))];
let _e1601 = ((_e1583 >> bitcast<u32>((_e1576 & 31u))) | ((_e1594 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1576) & 31u))));
let _e1602 = local_4.member_1[1u];
let _e1608 = f32(bitcast<i32>(((_e1601 >> bitcast<u32>((_e1602 & 31u))) & 255u)));
let _e1609 = local_4.member_1[2u];
let _e1616 = local_5[0u];
let _e1621 = local_4.member[0u];
let _e1622 = ((_e1093 + _e1094) + _e1621);
let _e1624 = (_e1622 >> bitcast<u32>(2i));
let _e1627 = bitcast<u32>(((_e1622 & 3i) * 8i));
let _e1629 = select(_e1078, _e1624, (_e1624 < _e1078));
let _e1634 = global_2.member[bitcast<u32>(select(0i, _e1629, (_e1629 > 0i)))];
let _e1638 = (_e1624 + 1i);
let _e1640 = select(_e1078, _e1638, (_e1638 < _e1078));
let _e1645 = global_2.member[bitcast<u32>(select(0i, _e1640, (_e1640 > 0i)))];
let _e1652 = ((_e1634 >> bitcast<u32>((_e1627 & 31u))) | ((_e1645 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1627) & 31u))));
let _e1653 = local_4.member_1[1u];
let _e1659 = f32(bitcast<i32>(((_e1652 >> bitcast<u32>((_e1653 & 31u))) & 255u)));
let _e1660 = local_4.member_1[2u];
let _e1667 = local_5[0u];
let _e1670 = (_e1659 + ((f32(bitcast<i32>(((_e1652 >> bitcast<u32>((_e1660 & 31u))) & 255u))) - _e1659) * _e1667));
let _e1672 = local_4.member[0u];
let _e1673 = ((_e1103 + _e1094) + _e1672);
let _e1675 = (_e1673 >> bitcast<u32>(2i));
let _e1678 = bitcast<u32>(((_e1673 & 3i) * 8i));
let _e1680 = select(_e1078, _e1675, (_e1675 < _e1078));
let _e1685 = global_2.member[bitcast<u32>(select(0i, _e1680, (_e1680 > 0i)))];
let _e1689 = (_e1675 + 1i);
let _e1691 = select(_e1078, _e1689, (_e1689 < _e1078));
let _e1696 = global_2.member[bitcast<u32>(select(0i, _e1691, (_e1691 > 0i)))];
let _e1703 = ((_e1685 >> bitcast<u32>((_e1678 & 31u))) | ((_e1696 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1678) & 31u))));
let _e1704 = local_4.member_1[1u];
let _e1710 = f32(bitcast<i32>(((_e1703 >> bitcast<u32>((_e1704 & 31u))) & 255u)));
let _e1711 = local_4.member_1[2u];
let _e1718 = local_5[0u];
let _e1721 = (_e1710 + ((f32(bitcast<i32>(((_e1703 >> bitcast<u32>((_e1711 & 31u))) & 255u))) - _e1710) * _e1718));
let _e1723 = local_4.member[0u];
let _e1724 = ((_e1093 + _e1096) + _e1723);
let _e1726 = (_e1724 >> bitcast<u32>(2i));
let _e1729 = bitcast<u32>(((_e1724 & 3i) * 8i));
let _e1731 = select(_e1078, _e1726, (_e1726 < _e1078));
let _e1736 = global_2.member[bitcast<u32>(select(0i, _e1731, (_e1731 > 0i)))];
let _e1740 = (_e1726 + 1i);
let _e1742 = select(_e1078, _e1740, (_e1740 < _e1078));
let _e1747 = global_2.member[bitcast<u32>(select(0i, _e1742, (_e1742 > 0i)))];
let _e1754 = ((_e1736 >> bitcast<u32>((_e1729 & 31u))) | ((_e1747 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1729) & 31u))));
let _e1755 = local_4.member_1[1u];
let _e1761 = f32(bitcast<i32>(((_e1754 >> bitcast<u32>((_e1755 & 31u))) & 255u)));
let _e1762 = local_4.member_1[2u];
let _e1769 = local_5[0u];
let _e1774 = local_4.member[0u];
let _e1775 = ((_e1103 + _e1096) + _e1774);
let _e1777 = (_e1775 >> bitcast<u32>(2i));
let _e1780 = bitcast<u32>(((_e1775 & 3i) * 8i));
let _e1782 = select(_e1078, _e1777, (_e1777 < _e1078));
let _e1787 = global_2.member[bitcast<u32>(select(0i, _e1782, (_e1782 > 0i)))];
let _e1791 = (_e1777 + 1i);
let _e1793 = select(_e1078, _e1791, (_e1791 < _e1078));
let _e1798 = global_2.member[bitcast<u32>(select(0i, _e1793, (_e1793 > 0i)))];
let _e1805 = ((_e1787 >> bitcast<u32>((_e1780 & 31u))) | ((_e1798 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1780) & 31u))));
let _e1806 = local_4.member_1[1u];
let _e1812 = f32(bitcast<i32>(((_e1805 >> bitcast<u32>((_e1806 & 31u))) & 255u)));
let _e1813 = local_4.member_1[2u];
let _e1820 = local_5[0u];
let _e1825 = local_5[1u];
let _e1828 = (_e1192 + ((_e1265 - _e1192) * _e1825));
let _e1829 = local_5[1u];
let _e1832 = (_e1338 + ((_e1411 - _e1338) * _e1829));
let _e1833 = local_5[1u];
let _e1836 = (_e1188 + (((_e1236 + ((_e1243 - _e1236) * _e1258)) - _e1188) * _e1833));
let _e1837 = local_5[1u];
let _e1842 = local_5[2u];
let _e1846 = local_5[1u];
let _e1849 = (_e1196 + (((_e1250 + ((f32(bitcast<i32>(((_e1229 >> bitcast<u32>((_e1251 & 31u))) & 255u))) - _e1250) * _e1266)) - _e1196) * _e1846));
let _e1850 = local_5[1u];
let _e1854 = local_5[2u];
let _e1858 = local_5[1u];
let _e1861 = (_e1466 + ((_e1192 - _e1466) * _e1858));
let _e1862 = local_5[1u];
let _e1866 = local_5[2u];
let _e1870 = local_5[1u];
let _e1873 = (_e1265 + (((_e1506 + ((f32(bitcast<i32>(((_e1499 >> bitcast<u32>((_e1507 & 31u))) & 255u))) - _e1506) * _e1514)) - _e1265) * _e1870));
let _e1874 = local_5[1u];
let _e1878 = local_5[2u];
let _e1882 = local_5[1u];
let _e1885 = (_e1670 + (((_e1761 + ((f32(bitcast<i32>(((_e1754 >> bitcast<u32>((_e1762 & 31u))) & 255u))) - _e1761) * _e1769)) - _e1670) * _e1882));
let _e1886 = local_5[2u];
let _e1890 = local_5[1u];
let _e1894 = local_5[2u];
let _e1898 = local_5[2u];
let _e1906 = global_1.member.member_5.member_4.member;
let _e1912 = global_1.member.member_5.member_4.member_1;
let _e1913 = (((_e1828 + ((_e1832 - _e1828) * _e1898)) * _e1906) + _e1912);
let _e1915 = select(0f, _e1913, (_e1913 > 0f));
let _e1917 = select(1f, _e1915, (_e1915 < 1f));
let _e1919 = (((_e1836 + (((_e1334 + (((_e1382 + ((_e1389 - _e1382) * _e1404)) - _e1334) * _e1837)) - _e1836) * _e1842)) * _e1906) + _e1912);
let _e1921 = select(0f, _e1919, (_e1919 > 0f));
let _e1923 = select(1f, _e1921, (_e1921 < 1f));
let _e1925 = (((_e1849 + (((_e1342 + (((_e1396 + ((f32(bitcast<i32>(((_e1375 >> bitcast<u32>((_e1397 & 31u))) & 255u))) - _e1396) * _e1412)) - _e1342) * _e1850)) - _e1849) * _e1854)) * _e1906) + _e1912);
let _e1927 = select(0f, _e1925, (_e1925 > 0f));
let _e1929 = select(1f, _e1927, (_e1927 < 1f));
let _e1931 = (((_e1861 + (((_e1568 + ((_e1338 - _e1568) * _e1862)) - _e1861) * _e1866)) * _e1906) + _e1912);
let _e1933 = select(0f, _e1931, (_e1931 > 0f));
let _e1935 = select(1f, _e1933, (_e1933 < 1f));
let _e1937 = (((_e1873 + (((_e1411 + (((_e1608 + ((f32(bitcast<i32>(((_e1601 >> bitcast<u32>((_e1609 & 31u))) & 255u))) - _e1608) * _e1616)) - _e1411) * _e1874)) - _e1873) * _e1878)) * _e1906) + _e1912);
let _e1939 = select(0f, _e1937, (_e1937 > 0f));
let _e1941 = select(1f, _e1939, (_e1939 < 1f));
let _e1943 = (((_e1885 + ((_e1828 - _e1885) * _e1886)) * _e1906) + _e1912);
let _e1945 = select(0f, _e1943, (_e1943 > 0f));
let _e1947 = select(1f, _e1945, (_e1945 < 1f));
let _e1949 = (((_e1832 + (((_e1721 + (((_e1812 + ((f32(bitcast<i32>(((_e1805 >> bitcast<u32>((_e1813 & 31u))) & 255u))) - _e1812) * _e1820)) - _e1721) * _e1890)) - _e1832) * _e1894)) * _e1906) + _e1912);
let _e1951 = select(0f, _e1949, (_e1949 > 0f));
let _e1953 = select(1f, _e1951, (_e1951 < 1f));
let _e1954 = (_e1917 * 1024f);
let _e1955 = (1024f - 1f);
let _e1957 = select(0f, _e1954, (_e1954 > 0f));
let _e1959 = select(_e1955, _e1957, (_e1957 < _e1955));
let _e1966 = select(0i, select(select(i32(_e1959), i32(-2147483648), (_e1959 < -2147483600f)), 2147483647i, (_e1959 > 2147483500f)), (_e1959 == _e1959));
let _e1970 = (_e1966 - select(0i, 1i, (_e1959 < f32(_e1966))));
let _e1971 = (262147i + _e1970);
let _e1973 = (bitcast<i32>(_e98) - 1i);
let _e1975 = select(_e1973, _e1971, (_e1971 < _e1973));
let _e1981 = global_4.member[bitcast<u32>(select(0i, _e1975, (_e1975 > 0i)))];
let _e1991 = select(_e1973, 262146i, (262146i < _e1973));
let _e1997 = global_4.member[bitcast<u32>(select(0i, _e1991, (_e1991 > 0i)))];
let _e1998 = bitcast<f32>(_e1997);
let _e1999 = (f32((bitcast<i32>((_e1981 & 4095u)) - 2048i)) * _e1998);
let _e2001 = select(_e1973, 262144i, (262144i < _e1973));
let _e2007 = global_4.member[bitcast<u32>(select(0i, _e2001, (_e2001 > 0i)))];
let _e2008 = bitcast<f32>(_e2007);
let _e2010 = select(_e1973, 262145i, (262145i < _e1973));
let _e2016 = global_4.member[bitcast<u32>(select(0i, _e2010, (_e2010 > 0i)))];
let _e2017 = bitcast<f32>(_e2016);
let _e2023 = ((_e2008 + (f32(bitcast<i32>((_e1981 >> bitcast<u32>(12u)))) * _e2017)) + (_e1999 * (_e1954 - f32(_e1970))));
let _e2024 = (_e1999 * 1024f);
if _e643 {
let _e2289 = ((0.5f * (_e1929 - _e1923)) * _e2024);
let _e2290 = ((0.5f * (_e1941 - _e1935)) * _e2024);
let _e2291 = ((0.5f * (_e1953 - _e1947)) * _e2024);
phi_5836_ = type_19(_e2023, vec3<f32>(_e2289, _e2290, _e2291), vec3<f32>((_e2289 * _e2023), (_e2290 * _e2023), (_e2291 * _e2023)));
} else {
let _e2025 = (_e1923 * 1024f);
let _e2027 = select(0f, _e2025, (_e2025 > 0f));
let _e2029 = select(_e1955, _e2027, (_e2027 < _e1955));
let _e2036 = select(0i, select(select(i32(_e2029), i32(-2147483648), (_e2029 < -2147483600f)), 2147483647i, (_e2029 > 2147483500f)), (_e2029 == _e2029));
let _e2040 = (_e2036 - select(0i, 1i, (_e2029 < f32(_e2036))));
let _e2041 = (262147i + _e2040);
let _e2043 = select(_e1973, _e2041, (_e2041 < _e1973));
let _e2049 = global_4.member[bitcast<u32>(select(0i, _e2043, (_e2043 > 0i)))];
let _e2064 = ((_e2008 + (f32(bitcast<i32>((_e2049 >> bitcast<u32>(12u)))) * _e2017)) + ((f32((bitcast<i32>((_e2049 & 4095u)) - 2048i)) * _e1998) * (_e2025 - f32(_e2040))));
let _e2065 = (_e1929 * 1024f);
let _e2067 = select(0f, _e2065, (_e2065 > 0f));
let _e2069 = select(_e1955, _e2067, (_e2067 < _e1955));
let _e2076 = select(0i, select(select(i32(_e2069), i32(-2147483648), (_e2069 < -2147483600f)), 2147483647i, (_e2069 > 2147483500f)), (_e2069 == _e2069));
let _e2080 = (_e2076 - select(0i, 1i, (_e2069 < f32(_e2076))));
let _e2081 = (262147i + _e2080);
let _e2083 = select(_e1973, _e2081, (_e2081 < _e1973));
let _e2089 = global_4.member[bitcast<u32>(select(0i, _e2083, (_e2083 > 0i)))];
let _e2104 = ((_e2008 + (f32(bitcast<i32>((_e2089 >> bitcast<u32>(12u)))) * _e2017)) + ((f32((bitcast<i32>((_e2089 & 4095u)) - 2048i)) * _e1998) * (_e2065 - f32(_e2080))));
let _e2105 = (_e1935 * 1024f);
let _e2107 = select(0f, _e2105, (_e2105 > 0f));
let _e2109 = select(_e1955, _e2107, (_e2107 < _e1955));
let _e2116 = select(0i, select(select(i32(_e2109), i32(-2147483648), (_e2109 < -2147483600f)), 2147483647i, (_e2109 > 2147483500f)), (_e2109 == _e2109));
let _e2120 = (_e2116 - select(0i, 1i, (_e2109 < f32(_e2116))));
let _e2121 = (262147i + _e2120);
let _e2123 = select(_e1973, _e2121, (_e2121 < _e1973));
let _e2129 = global_4.member[bitcast<u32>(select(0i, _e2123, (_e2123 > 0i)))];
let _e2144 = ((_e2008 + (f32(bitcast<i32>((_e2129 >> bitcast<u32>(12u)))) * _e2017)) + ((f32((bitcast<i32>((_e2129 & 4095u)) - 2048i)) * _e1998) * (_e2105 - f32(_e2120))));
let _e2145 = (_e1941 * 1024f);
let _e2147 = select(0f, _e2145, (_e2145 > 0f));
let _e2149 = select(_e1955, _e2147, (_e2147 < _e1955));
let _e2156 = select(0i, select(select(i32(_e2149), i32(-2147483648), (_e2149 < -2147483600f)), 2147483647i, (_e2149 > 2147483500f)), (_e2149 == _e2149));
let _e2160 = (_e2156 - select(0i, 1i, (_e2149 < f32(_e2156))));
let _e2161 = (262147i + _e2160);
let _e2163 = select(_e1973, _e2161, (_e2161 < _e1973));
let _e2169 = global_4.member[bitcast<u32>(select(0i, _e2163, (_e2163 > 0i)))];
let _e2184 = ((_e2008 + (f32(bitcast<i32>((_e2169 >> bitcast<u32>(12u)))) * _e2017)) + ((f32((bitcast<i32>((_e2169 & 4095u)) - 2048i)) * _e1998) * (_e2145 - f32(_e2160))));
let _e2185 = (_e1947 * 1024f);
let _e2187 = select(0f, _e2185, (_e2185 > 0f));
let _e2189 = select(_e1955, _e2187, (_e2187 < _e1955));
let _e2196 = select(0i, select(select(i32(_e2189), i32(-2147483648), (_e2189 < -2147483600f)), 2147483647i, (_e2189 > 2147483500f)), (_e2189 == _e2189));
let _e2200 = (_e2196 - select(0i, 1i, (_e2189 < f32(_e2196))));
let _e2201 = (262147i + _e2200);
let _e2203 = select(_e1973, _e2201, (_e2201 < _e1973));
let _e2209 = global_4.member[bitcast<u32>(select(0i, _e2203, (_e2203 > 0i)))];
let _e2224 = ((_e2008 + (f32(bitcast<i32>((_e2209 >> bitcast<u32>(12u)))) * _e2017)) + ((f32((bitcast<i32>((_e2209 & 4095u)) - 2048i)) * _e1998) * (_e2185 - f32(_e2200))));
let _e2225 = (_e1953 * 1024f);
let _e2227 = select(0f, _e2225, (_e2225 > 0f));
let _e2229 = select(_e1955, _e2227, (_e2227 < _e1955));
let _e2236 = select(0i, select(select(i32(_e2229), i32(-2147483648), (_e2229 < -2147483600f)), 2147483647i, (_e2229 > 2147483500f)), (_e2229 == _e2229));
let _e2240 = (_e2236 - select(0i, 1i, (_e2229 < f32(_e2236))));
let _e2241 = (262147i + _e2240);
let _e2243 = select(_e1973, _e2241, (_e2241 < _e1973));
let _e2249 = global_4.member[bitcast<u32>(select(0i, _e2243, (_e2243 > 0i)))];
let _e2264 = ((_e2008 + (f32(bitcast<i32>((_e2249 >> bitcast<u32>(12u)))) * _e2017)) + ((f32((bitcast<i32>((_e2249 & 4095u)) - 2048i)) * _e1998) * (_e2225 - f32(_e2240))));
let _e2265 = (_e2104 - _e2064);
let _e2267 = (_e2184 - _e2144);
let _e2269 = (_e2264 - _e2224);
phi_5836_ = type_19(_e2023, vec3<f32>((0.5f * _e2265), (0.5f * _e2267), (0.5f * _e2269)), vec3<f32>((0.25f * (_e2265 * (_e2104 + _e2064))), (0.25f * (_e2267 * (_e2184 + _e2144))), (0.25f * (_e2269 * (_e2264 + _e2224)))));
}
let _e2299 = phi_5836_;
let _e2314 = select(0f, 1f, ((((((_e445 >= -0.5f) && (_e445 <= _e468)) && (_e451 >= -0.5f)) && (_e451 <= _e478)) && (_e457 >= -0.5f)) && (_e457 <= _e488)));
let _e2316 = (0.5f * (_e1929 - _e1923));
let _e2318 = (0.5f * (_e1941 - _e1935));
let _e2320 = (0.5f * (_e1953 - _e1947));
let _e2325 = global_1.member.member_5.member.member;
let _e2331 = global_1.member.member_5.member_1.member;
let _e2338 = global_1.member.member_5.member_2.member;
let _e2345 = global_1.member.member_5.member.member_1;
let _e2351 = global_1.member.member_5.member_1.member_1;
let _e2358 = global_1.member.member_5.member_2.member_1;
let _e2365 = global_1.member.member_5.member.member_2;
let _e2371 = global_1.member.member_5.member_1.member_2;
let _e2378 = global_1.member.member_5.member_2.member_2;
phi_7157_ = type_20(_e1917, vec3<f32>(((((_e2325 * _e2316) + (_e2331 * _e2318)) + (_e2338 * _e2320)) * _e2314), ((((_e2345 * _e2316) + (_e2351 * _e2318)) + (_e2358 * _e2320)) * _e2314), ((((_e2365 * _e2316) + (_e2371 * _e2318)) + (_e2378 * _e2320)) * _e2314)), _e2299.member, vec3<f32>(((((_e2325 * _e2299.member_2.x) + (_e2331 * _e2299.member_2.y)) + (_e2338 * _e2299.member_2.z)) * _e2314), ((((_e2345 * _e2299.member_2.x) + (_e2351 * _e2299.member_2.y)) + (_e2358 * _e2299.member_2.z)) * _e2314), ((((_e2365 * _e2299.member_2.x) + (_e2371 * _e2299.member_2.y)) + (_e2378 * _e2299.member_2.z)) * _e2314)), vec3<f32>(((((_e2325 * _e2299.member_1.x) + (_e2331 * _e2299.member_1.y)) + (_e2338 * _e2299.member_1.z)) * _e2314), ((((_e2345 * _e2299.member_1.x) + (_e2351 * _e2299.member_1.y)) + (_e2358 * _e2299.member_1.z)) * _e2314), ((((_e2365 * _e2299.member_1.x) + (_e2371 * _e2299.member_1.y)) + (_e2378 * _e2299.member_1.z)) * _e2314)));
} else {
let _e648 = select(-1f, _e472, (_e472 > -1f));
let _e650 = select(_e467, _e648, (_e648 < _e467));
let _e657 = select(0i, select(select(i32(_e650), i32(-2147483648), (_e650 < -2147483600f)), 2147483647i, (_e650 > 2147483500f)), (_e650 == _e650));
let _e661 = (_e657 - select(0i, 1i, (_e650 < f32(_e657))));
let _e663 = select(-1f, _e482, (_e482 > -1f));
let _e665 = select(_e477, _e663, (_e663 < _e477));
let _e672 = select(0i, select(select(i32(_e665), i32(-2147483648), (_e665 < -2147483600f)), 2147483647i, (_e665 > 2147483500f)), (_e665 == _e665));
let _e676 = (_e672 - select(0i, 1i, (_e665 < f32(_e672))));
let _e678 = select(-1f, _e492, (_e492 > -1f));
let _e680 = select(_e487, _e678, (_e678 < _e487));
let _e687 = select(0i, select(select(i32(_e680), i32(-2147483648), (_e680 < -2147483600f)), 2147483647i, (_e680 > 2147483500f)), (_e680 == _e680));
let _e691 = (_e687 - select(0i, 1i, (_e680 < f32(_e687))));
let _e696 = global_1.member.member_5.member_5[0u];
let _e701 = global_1.member.member_5.member_5[1u];
let _e702 = (_e661 + 1i);
let _e703 = (_e676 + 1i);
let _e704 = (_e691 + 1i);
let _e711 = global_1.member.member_5.member_7[0u];
let _e718 = global_1.member.member_5.member_7[1u];
let _e724 = ((_e702 >> bitcast<u32>(4i)) + (_e711 * ((_e703 >> bitcast<u32>(4i)) + (_e718 * (_e704 >> bitcast<u32>(4i))))));
let _e726 = (bitcast<i32>(_e94) - 1i);
let _e728 = select(_e726, _e724, (_e724 < _e726));
let _e734 = global_2.member[bitcast<u32>(select(0i, _e728, (_e728 > 0i)))];
let _e736 = (_e702 & 15i);
let _e739 = ((_e703 & 15i) * _e696);
let _e741 = (bitcast<i32>(_e734) + ((_e704 & 15i) * _e701));
let _e742 = (_e739 + _e696);
let _e744 = (_e739 + (2i * _e696));
let _e745 = (_e741 + _e701);
let _e747 = (_e741 + (2i * _e701));
local_2 = type_18(array<i32, 4>(_e736, _e736, _e736, _e736), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_3 = vec3<f32>((_e472 - f32(_e661)), (_e482 - f32(_e676)), (_e492 - f32(_e691)));
let _e761 = local_2.member[0u];
let _e762 = ((_e745 + _e742) + _e761);
let _e764 = (_e762 >> bitcast<u32>(2i));
let _e767 = bitcast<u32>(((_e762 & 3i) * 8i));
let _e769 = select(_e726, _e764, (_e764 < _e726));
let _e774 = global_2.member[bitcast<u32>(select(0i, _e769, (_e769 > 0i)))];
let _e778 = (_e764 + 1i);
let _e780 = select(_e726, _e778, (_e778 < _e726));
let _e785 = global_2.member[bitcast<u32>(select(0i, _e780, (_e780 > 0i)))];
let _e792 = ((_e774 >> bitcast<u32>((_e767 & 31u))) | ((_e785 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e767) & 31u))));
let _e795 = local_2.member_1[1u];
let _e801 = f32(bitcast<i32>(((_e792 >> bitcast<u32>((_e795 & 31u))) & 255u)));
let _e804 = local_2.member_1[2u];
let _e811 = local_3[0u];
let _e814 = (_e801 + ((f32(bitcast<i32>(((_e792 >> bitcast<u32>((_e804 & 31u))) & 255u))) - _e801) * _e811));
let _e816 = local_2.member[0u];
let _e817 = ((_e745 + _e744) + _e816);
let _e819 = (_e817 >> bitcast<u32>(2i));
let _e822 = bitcast<u32>(((_e817 & 3i) * 8i));
let _e824 = select(_e726, _e819, (_e819 < _e726));
let _e829 = global_2.member[bitcast<u32>(select(0i, _e824, (_e824 > 0i)))];
let _e833 = (_e819 + 1i);
let _e835 = select(_e726, _e833, (_e833 < _e726));
let _e840 = global_2.member[bitcast<u32>(select(0i, _e835, (_e835 > 0i)))];
let _e847 = ((_e829 >> bitcast<u32>((_e822 & 31u))) | ((_e840 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e822) & 31u))));
let _e848 = local_2.member_1[1u];
let _e854 = f32(bitcast<i32>(((_e847 >> bitcast<u32>((_e848 & 31u))) & 255u)));
let _e855 = local_2.member_1[2u];
let _e862 = local_3[0u];
let _e867 = local_3[1u];
let _e870 = (_e814 + (((_e854 + ((f32(bitcast<i32>(((_e847 >> bitcast<u32>((_e855 & 31u))) & 255u))) - _e854) * _e862)) - _e814) * _e867));
let _e872 = local_2.member[0u];
let _e873 = ((_e747 + _e742) + _e872);
let _e875 = (_e873 >> bitcast<u32>(2i));
let _e878 = bitcast<u32>(((_e873 & 3i) * 8i));
let _e880 = select(_e726, _e875, (_e875 < _e726));
let _e885 = global_2.member[bitcast<u32>(select(0i, _e880, (_e880 > 0i)))];
let _e889 = (_e875 + 1i);
let _e891 = select(_e726, _e889, (_e889 < _e726));
let _e896 = global_2.member[bitcast<u32>(select(0i, _e891, (_e891 > 0i)))];
let _e903 = ((_e885 >> bitcast<u32>((_e878 & 31u))) | ((_e896 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e878) & 31u))));
let _e904 = local_2.member_1[1u];
let _e910 = f32(bitcast<i32>(((_e903 >> bitcast<u32>((_e904 & 31u))) & 255u)));
let _e911 = local_2.member_1[2u];
let _e918 = local_3[0u];
let _e921 = (_e910 + ((f32(bitcast<i32>(((_e903 >> bitcast<u32>((_e911 & 31u))) & 255u))) - _e910) * _e918));
let _e923 = local_2.member[0u];
let _e924 = ((_e747 + _e744) + _e923);
let _e926 = (_e924 >> bitcast<u32>(2i));
let _e929 = bitcast<u32>(((_e924 & 3i) * 8i));
let _e931 = select(_e726, _e926, (_e926 < _e726));
let _e936 = global_2.member[bitcast<u32>(select(0i, _e931, (_e931 > 0i)))];
let _e940 = (_e926 + 1i);
let _e942 = select(_e726, _e940, (_e940 < _e726));
let _e947 = global_2.member[bitcast<u32>(select(0i, _e942, (_e942 > 0i)))];
let _e954 = ((_e936 >> bitcast<u32>((_e929 & 31u))) | ((_e947 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e929) & 31u))));
let _e955 = local_2.member_1[1u];
let _e961 = f32(bitcast<i32>(((_e954 >> bitcast<u32>((_e955 & 31u))) & 255u)));
let _e962 = local_2.member_1[2u];
let _e969 = local_3[0u];
let _e973 = local_3[1u];
let _e978 = local_3[2u];
let _e986 = global_1.member.member_5.member_4.member;
let _e992 = global_1.member.member_5.member_4.member_1;
let _e993 = (((_e870 + (((_e921 + (((_e961 + ((f32(bitcast<i32>(((_e954 >> bitcast<u32>((_e962 & 31u))) & 255u))) - _e961) * _e969)) - _e921) * _e973)) - _e870) * _e978)) * _e986) + _e992);
let _e995 = select(0f, _e993, (_e993 > 0f));
phi_7157_ = type_20(select(1f, _e995, (_e995 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2431 = phi_7157_;
let _e2433 = select(-0.5f, _e403, (_e403 > -0.5f));
let _e2435 = select(_e468, _e2433, (_e2433 < _e468));
let _e2437 = select(-0.5f, _e421, (_e421 > -0.5f));
let _e2439 = select(_e478, _e2437, (_e2437 < _e478));
let _e2441 = select(-0.5f, _e439, (_e439 > -0.5f));
let _e2443 = select(_e488, _e2441, (_e2441 < _e488));
let _e2445 = select(-1f, _e2435, (_e2435 > -1f));
let _e2447 = select(_e467, _e2445, (_e2445 < _e467));
let _e2454 = select(0i, select(select(i32(_e2447), i32(-2147483648), (_e2447 < -2147483600f)), 2147483647i, (_e2447 > 2147483500f)), (_e2447 == _e2447));
let _e2458 = (_e2454 - select(0i, 1i, (_e2447 < f32(_e2454))));
let _e2460 = select(-1f, _e2439, (_e2439 > -1f));
let _e2462 = select(_e477, _e2460, (_e2460 < _e477));
let _e2469 = select(0i, select(select(i32(_e2462), i32(-2147483648), (_e2462 < -2147483600f)), 2147483647i, (_e2462 > 2147483500f)), (_e2462 == _e2462));
let _e2473 = (_e2469 - select(0i, 1i, (_e2462 < f32(_e2469))));
let _e2475 = select(-1f, _e2443, (_e2443 > -1f));
let _e2477 = select(_e487, _e2475, (_e2475 < _e487));
let _e2484 = select(0i, select(select(i32(_e2477), i32(-2147483648), (_e2477 < -2147483600f)), 2147483647i, (_e2477 > 2147483500f)), (_e2477 == _e2477));
let _e2488 = (_e2484 - select(0i, 1i, (_e2477 < f32(_e2484))));
let _e2493 = global_1.member.member_5.member_5[0u];
let _e2498 = global_1.member.member_5.member_5[1u];
let _e2499 = (_e2458 + 1i);
let _e2500 = (_e2473 + 1i);
let _e2501 = (_e2488 + 1i);
let _e2508 = global_1.member.member_5.member_7[0u];
let _e2515 = global_1.member.member_5.member_7[1u];
let _e2521 = ((_e2499 >> bitcast<u32>(4i)) + (_e2508 * ((_e2500 >> bitcast<u32>(4i)) + (_e2515 * (_e2501 >> bitcast<u32>(4i))))));
let _e2523 = (bitcast<i32>(_e94) - 1i);
let _e2525 = select(_e2523, _e2521, (_e2521 < _e2523));
let _e2531 = global_2.member[bitcast<u32>(select(0i, _e2525, (_e2525 > 0i)))];
let _e2533 = (_e2499 & 15i);
let _e2536 = ((_e2500 & 15i) * _e2493);
let _e2538 = (bitcast<i32>(_e2531) + ((_e2501 & 15i) * _e2498));
let _e2539 = (_e2536 + _e2493);
let _e2541 = (_e2536 + (2i * _e2493));
let _e2542 = (_e2538 + _e2498);
let _e2544 = (_e2538 + (2i * _e2498));
local = type_18(array<i32, 4>(_e2533, _e2533, _e2533, _e2533), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_1 = vec3<f32>((_e2435 - f32(_e2458)), (_e2439 - f32(_e2473)), (_e2443 - f32(_e2488)));
let _e2558 = local.member[0u];
let _e2559 = ((_e2542 + _e2539) + _e2558);
let _e2561 = (_e2559 >> bitcast<u32>(2i));
let _e2564 = bitcast<u32>(((_e2559 & 3i) * 8i));
let _e2566 = select(_e2523, _e2561, (_e2561 < _e2523));
let _e2571 = global_2.member[bitcast<u32>(select(0i, _e2566, (_e2566 > 0i)))];
let _e2575 = (_e2561 + 1i);
let _e2577 = select(_e2523, _e2575, (_e2575 < _e2523));
let _e2582 = global_2.member[bitcast<u32>(select(0i, _e2577, (_e2577 > 0i)))];
let _e2589 = ((_e2571 >> bitcast<u32>((_e2564 & 31u))) | ((_e2582 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2564) & 31u))));
let _e2592 = local.member_1[1u];
let _e2598 = f32(bitcast<i32>(((_e2589 >> bitcast<u32>((_e2592 & 31u))) & 255u)));
let _e2601 = local.member_1[2u];
let _e2608 = local_1[0u];
let _e2611 = (_e2598 + ((f32(bitcast<i32>(((_e2589 >> bitcast<u32>((_e2601 & 31u))) & 255u))) - _e2598) * _e2608));
let _e2613 = local.member[0u];
let _e2614 = ((_e2542 + _e2541) + _e2613);
let _e2616 = (_e2614 >> bitcast<u32>(2i));
let _e2619 = bitcast<u32>(((_e2614 & 3i) * 8i));
let _e2621 = select(_e2523, _e2616, (_e2616 < _e2523));
let _e2626 = global_2.member[bitcast<u32>(select(0i, _e2621, (_e2621 > 0i)))];
let _e2630 = (_e2616 + 1i);
let _e2632 = select(_e2523, _e2630, (_e2630 < _e2523));
let _e2637 = global_2.member[bitcast<u32>(select(0i, _e2632, (_e2632 > 0i)))];
let _e2644 = ((_e2626 >> bitcast<u32>((_e2619 & 31u))) | ((_e2637 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2619) & 31u))));
let _e2645 = local.member_1[1u];
let _e2651 = f32(bitcast<i32>(((_e2644 >> bitcast<u32>((_e2645 & 31u))) & 255u)));
let _e2652 = local.member_1[2u];
let _e2659 = local_1[0u];
let _e2664 = local_1[1u];
let _e2667 = (_e2611 + (((_e2651 + ((f32(bitcast<i32>(((_e2644 >> bitcast<u32>((_e2652 & 31u))) & 255u))) - _e2651) * _e2659)) - _e2611) * _e2664));
let _e2669 = local.member[0u];
let _e2670 = ((_e2544 + _e2539) + _e2669);
let _e2672 = (_e2670 >> bitcast<u32>(2i));
let _e2675 = bitcast<u32>(((_e2670 & 3i) * 8i));
let _e2677 = select(_e2523, _e2672, (_e2672 < _e2523));
let _e2682 = global_2.member[bitcast<u32>(select(0i, _e2677, (_e2677 > 0i)))];
let _e2686 = (_e2672 + 1i);
let _e2688 = select(_e2523, _e2686, (_e2686 < _e2523));
let _e2693 = global_2.member[bitcast<u32>(select(0i, _e2688, (_e2688 > 0i)))];
let _e2700 = ((_e2682 >> bitcast<u32>((_e2675 & 31u))) | ((_e2693 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2675) & 31u))));
let _e2701 = local.member_1[1u];
let _e2707 = f32(bitcast<i32>(((_e2700 >> bitcast<u32>((_e2701 & 31u))) & 255u)));
let _e2708 = local.member_1[2u];
let _e2715 = local_1[0u];
let _e2718 = (_e2707 + ((f32(bitcast<i32>(((_e2700 >> bitcast<u32>((_e2708 & 31u))) & 255u))) - _e2707) * _e2715));
let _e2720 = local.member[0u];
let _e2721 = ((_e2544 + _e2541) + _e2720);
let _e2723 = (_e2721 >> bitcast<u32>(2i));
let _e2726 = bitcast<u32>(((_e2721 & 3i) * 8i));
let _e2728 = select(_e2523, _e2723, (_e2723 < _e2523));
let _e2733 = global_2.member[bitcast<u32>(select(0i, _e2728, (_e2728 > 0i)))];
let _e2737 = (_e2723 + 1i);
let _e2739 = select(_e2523, _e2737, (_e2737 < _e2523));
let _e2744 = global_2.member[bitcast<u32>(select(0i, _e2739, (_e2739 > 0i)))];
let _e2751 = ((_e2733 >> bitcast<u32>((_e2726 & 31u))) | ((_e2744 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2726) & 31u))));
let _e2752 = local.member_1[1u];
let _e2758 = f32(bitcast<i32>(((_e2751 >> bitcast<u32>((_e2752 & 31u))) & 255u)));
let _e2759 = local.member_1[2u];
let _e2766 = local_1[0u];
let _e2770 = local_1[1u];
let _e2775 = local_1[2u];
let _e2783 = global_1.member.member_5.member_4.member;
let _e2789 = global_1.member.member_5.member_4.member_1;
let _e2790 = (((_e2667 + (((_e2718 + (((_e2758 + ((f32(bitcast<i32>(((_e2751 >> bitcast<u32>((_e2759 & 31u))) & 255u))) - _e2758) * _e2766)) - _e2718) * _e2770)) - _e2667) * _e2775)) * _e2783) + _e2789);
let _e2792 = select(0f, _e2790, (_e2790 > 0f));
if ((_e626 & 16u) == 0u) {
phi_8679_ = type_21(1f, 1f, 1f);
} else {
let _e2799 = global_1.member.member_18;
let _e2803 = global_1.member.member_22.member;
let _e2813 = ((((_e2799.member * _e311) + (_e2799.member_1 * _e320)) + (_e2799.member_2 * _e293)) + _e2799.member_3);
let _e2819 = ((((_e2799.member * _e332) + (_e2799.member_1 * _e337)) + (_e2799.member_2 * _e326)) + _e2799.member_3);
let _e2821 = select(_e2819, _e2813, (_e2813 < _e2819));
let _e2823 = select(_e2819, _e2813, (_e2813 > _e2819));
let _e2825 = (_e2823 - _e2821);
let _e2828 = (-(_e2821) / select(1e-30f, _e2825, (_e2825 > 1e-30f)));
let _e2830 = select(0f, _e2828, (_e2828 > 0f));
let _e2836 = select(select(select(1f, _e2830, (_e2830 < 1f)), 1f, (_e2823 <= 0f)), 0f, (_e2821 > 0f));
let _e2838 = (_e2803 > 0.5f);
let _e2847 = global_1.member.member_19;
let _e2851 = global_1.member.member_22.member_1;
let _e2861 = ((((_e2847.member * _e311) + (_e2847.member_1 * _e320)) + (_e2847.member_2 * _e293)) + _e2847.member_3);
let _e2867 = ((((_e2847.member * _e332) + (_e2847.member_1 * _e337)) + (_e2847.member_2 * _e326)) + _e2847.member_3);
let _e2869 = select(_e2867, _e2861, (_e2861 < _e2867));
let _e2871 = select(_e2867, _e2861, (_e2861 > _e2867));
let _e2873 = (_e2871 - _e2869);
let _e2876 = (-(_e2869) / select(1e-30f, _e2873, (_e2873 > 1e-30f)));
let _e2878 = select(0f, _e2876, (_e2876 > 0f));
let _e2884 = select(select(select(1f, _e2878, (_e2878 < 1f)), 1f, (_e2871 <= 0f)), 0f, (_e2869 > 0f));
let _e2886 = (_e2851 > 0.5f);
let _e2895 = global_1.member.member_20;
let _e2899 = global_1.member.member_22.member_2;
let _e2909 = ((((_e2895.member * _e311) + (_e2895.member_1 * _e320)) + (_e2895.member_2 * _e293)) + _e2895.member_3);
let _e2915 = ((((_e2895.member * _e332) + (_e2895.member_1 * _e337)) + (_e2895.member_2 * _e326)) + _e2895.member_3);
let _e2917 = select(_e2915, _e2909, (_e2909 < _e2915));
let _e2919 = select(_e2915, _e2909, (_e2909 > _e2915));
let _e2921 = (_e2919 - _e2917);
let _e2924 = (-(_e2917) / select(1e-30f, _e2921, (_e2921 > 1e-30f)));
let _e2926 = select(0f, _e2924, (_e2924 > 0f));
let _e2932 = select(select(select(1f, _e2926, (_e2926 < 1f)), 1f, (_e2919 <= 0f)), 0f, (_e2917 > 0f));
let _e2934 = (_e2899 > 0.5f);
let _e2943 = global_1.member.member_21;
let _e2947 = global_1.member.member_22.member_3;
let _e2957 = ((((_e2943.member * _e311) + (_e2943.member_1 * _e320)) + (_e2943.member_2 * _e293)) + _e2943.member_3);
let _e2963 = ((((_e2943.member * _e332) + (_e2943.member_1 * _e337)) + (_e2943.member_2 * _e326)) + _e2943.member_3);
let _e2965 = select(_e2963, _e2957, (_e2957 < _e2963));
let _e2967 = select(_e2963, _e2957, (_e2957 > _e2963));
let _e2969 = (_e2967 - _e2965);
let _e2972 = (-(_e2965) / select(1e-30f, _e2969, (_e2969 > 1e-30f)));
let _e2974 = select(0f, _e2972, (_e2972 > 0f));
let _e2980 = select(select(select(1f, _e2974, (_e2974 < 1f)), 1f, (_e2967 <= 0f)), 0f, (_e2965 > 0f));
let _e2982 = (_e2947 > 0.5f);
phi_8679_ = type_21(((((1f * _e2836) * _e2884) * _e2932) * _e2980), ((((1f * select(1f, _e2836, _e2838)) * select(1f, _e2884, _e2886)) * select(1f, _e2932, _e2934)) * select(1f, _e2980, _e2982)), ((((1f * select(1f, 0f, (_e2838 && (_e2819 > 0f)))) * select(1f, 0f, (_e2886 && (_e2867 > 0f)))) * select(1f, 0f, (_e2934 && (_e2915 > 0f)))) * select(1f, 0f, (_e2982 && (_e2963 > 0f)))));
}
let _e2991 = phi_8679_;
let _e2992 = (_e332 - _e311);
let _e2993 = (_e337 - _e320);
let _e2994 = (_e326 - _e293);
let _e2999 = (((_e2992 * _e2992) + (_e2993 * _e2993)) + (_e2994 * _e2994));
let _e3003 = (_e498 < 1e-12f);
let _e3005 = (1f / select(_e493, 1f, _e3003));
let _e3007 = ((-0.5f - _e403) * _e3005);
let _e3009 = ((_e468 - _e403) * _e3005);
let _e3015 = select(_e3009, _e3007, (_e3007 < _e3009));
let _e3017 = select(0f, _e3015, (_e3015 > 0f));
let _e3020 = select(select(1f, _e3017, (_e3017 < 1f)), select(2f, 0f, ((_e403 >= -0.5f) && (_e403 <= _e468))), _e3003);
let _e3022 = select(_e3009, _e3007, (_e3007 > _e3009));
let _e3024 = select(0f, _e3022, (_e3022 > 0f));
let _e3027 = select(select(1f, _e3024, (_e3024 < 1f)), 1f, _e3003);
let _e3028 = (_e501 < 1e-12f);
let _e3030 = (1f / select(_e494, 1f, _e3028));
let _e3032 = ((-0.5f - _e421) * _e3030);
let _e3034 = ((_e478 - _e421) * _e3030);
let _e3040 = select(_e3034, _e3032, (_e3032 < _e3034));
let _e3042 = select(0f, _e3040, (_e3040 > 0f));
let _e3045 = select(select(1f, _e3042, (_e3042 < 1f)), select(2f, 0f, ((_e421 >= -0.5f) && (_e421 <= _e478))), _e3028);
let _e3047 = select(_e3034, _e3032, (_e3032 > _e3034));
let _e3049 = select(0f, _e3047, (_e3047 > 0f));
let _e3052 = select(select(1f, _e3049, (_e3049 < 1f)), 1f, _e3028);
let _e3053 = (_e506 < 1e-12f);
let _e3055 = (1f / select(_e495, 1f, _e3053));
let _e3057 = ((-0.5f - _e439) * _e3055);
let _e3059 = ((_e488 - _e439) * _e3055);
let _e3065 = select(_e3059, _e3057, (_e3057 < _e3059));
let _e3067 = select(0f, _e3065, (_e3065 > 0f));
let _e3070 = select(select(1f, _e3067, (_e3067 < 1f)), select(2f, 0f, ((_e439 >= -0.5f) && (_e439 <= _e488))), _e3053);
let _e3072 = select(_e3059, _e3057, (_e3057 > _e3059));
let _e3074 = select(0f, _e3072, (_e3072 > 0f));
let _e3077 = select(select(1f, _e3074, (_e3074 < 1f)), 1f, _e3053);
let _e3079 = select(_e3052, _e3027, (_e3027 < _e3052));
let _e3083 = select(_e3045, _e3020, (_e3020 > _e3045));
let _e3086 = (select(_e3077, _e3079, (_e3079 < _e3077)) - select(_e3070, _e3083, (_e3083 > _e3070)));
let _e3093 = global_1.member.member_4.member_3;
let _e3094 = ((sqrt(select(0f, _e2999, (_e2999 > 0f))) * select(0f, _e3086, (_e3086 > 0f))) * _e3093);
let _e3096 = (select(1f, _e2792, (_e2792 < 1f)) * 255f);
let _e3097 = (_e2431.member * 255f);
let _e3098 = (255f - 1f);
let _e3100 = select(0f, _e3096, (_e3096 > 0f));
let _e3102 = select(_e3098, _e3100, (_e3100 < _e3098));
let _e3109 = select(0i, select(select(i32(_e3102), i32(-2147483648), (_e3102 < -2147483600f)), 2147483647i, (_e3102 > 2147483500f)), (_e3102 == _e3102));
let _e3113 = (_e3109 - select(0i, 1i, (_e3102 < f32(_e3109))));
let _e3115 = select(0f, _e3097, (_e3097 > 0f));
let _e3117 = select(_e3098, _e3115, (_e3115 < _e3098));
let _e3124 = select(0i, select(select(i32(_e3117), i32(-2147483648), (_e3117 < -2147483600f)), 2147483647i, (_e3117 > 2147483500f)), (_e3117 == _e3117));
let _e3128 = (_e3124 - select(0i, 1i, (_e3117 < f32(_e3124))));
let _e3131 = (((_e3113 * 256i) + _e3128) * 4i);
let _e3133 = (_e3096 - f32(_e3113));
let _e3135 = (_e3097 - f32(_e3128));
let _e3137 = (bitcast<i32>(_e98) - 1i);
let _e3139 = select(_e3137, _e3131, (_e3131 < _e3137));
let _e3145 = global_4.member[bitcast<u32>(select(0i, _e3139, (_e3139 > 0i)))];
let _e3146 = (_e3131 + 4i);
let _e3148 = select(_e3137, _e3146, (_e3146 < _e3137));
let _e3154 = global_4.member[bitcast<u32>(select(0i, _e3148, (_e3148 > 0i)))];
let _e3155 = (_e3131 + 1024i);
let _e3157 = select(_e3137, _e3155, (_e3155 < _e3137));
let _e3163 = global_4.member[bitcast<u32>(select(0i, _e3157, (_e3157 > 0i)))];
let _e3164 = (_e3131 + 1028i);
let _e3166 = select(_e3137, _e3164, (_e3164 < _e3137));
let _e3172 = global_4.member[bitcast<u32>(select(0i, _e3166, (_e3166 > 0i)))];
let _e3177 = (bitcast<f32>(((_e3145 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3185 = (_e3177 + (((bitcast<f32>(((_e3154 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3177) * _e3135));
let _e3190 = (bitcast<f32>(((_e3163 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3214 = (bitcast<f32>((((_e3145 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3222 = (_e3214 + (((bitcast<f32>((((_e3154 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3214) * _e3135));
let _e3227 = (bitcast<f32>((((_e3163 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3239 = (_e3131 + 1i);
let _e3241 = select(_e3137, _e3239, (_e3239 < _e3137));
let _e3247 = global_4.member[bitcast<u32>(select(0i, _e3241, (_e3241 > 0i)))];
let _e3248 = (_e3131 + 5i);
let _e3250 = select(_e3137, _e3248, (_e3248 < _e3137));
let _e3256 = global_4.member[bitcast<u32>(select(0i, _e3250, (_e3250 > 0i)))];
let _e3257 = (_e3131 + 1025i);
let _e3259 = select(_e3137, _e3257, (_e3257 < _e3137));
let _e3265 = global_4.member[bitcast<u32>(select(0i, _e3259, (_e3259 > 0i)))];
let _e3266 = (_e3131 + 1029i);
let _e3268 = select(_e3137, _e3266, (_e3266 < _e3137));
let _e3274 = global_4.member[bitcast<u32>(select(0i, _e3268, (_e3268 > 0i)))];
let _e3279 = (bitcast<f32>(((_e3247 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3287 = (_e3279 + (((bitcast<f32>(((_e3256 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3279) * _e3135));
let _e3292 = (bitcast<f32>(((_e3265 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3316 = (bitcast<f32>((((_e3247 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3324 = (_e3316 + (((bitcast<f32>((((_e3256 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3316) * _e3135));
let _e3329 = (bitcast<f32>((((_e3265 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3344 = (_e3094 * _e2991.member_1);
let _e3346 = -(((_e3222 + (((_e3227 + (((bitcast<f32>((((_e3172 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3227) * _e3135)) - _e3222) * _e3133)) * _e3344));
let _e3348 = select(-87f, _e3346, (_e3346 > -87f));
let _e3350 = select(88f, _e3348, (_e3348 < 88f));
let _e3352 = ((_e3350 * 1.442695f) + 0.5f);
let _e3354 = select(-127f, _e3352, (_e3352 > -127f));
let _e3356 = select(128f, _e3354, (_e3354 < 128f));
let _e3363 = select(0i, select(select(i32(_e3356), i32(-2147483648), (_e3356 < -2147483600f)), 2147483647i, (_e3356 > 2147483500f)), (_e3356 == _e3356));
let _e3367 = (_e3363 - select(0i, 1i, (_e3356 < f32(_e3363))));
let _e3368 = f32(_e3367);
let _e3372 = ((_e3350 - (_e3368 * 0.6933594f)) - (_e3368 * -2.1219444e-4f));
let _e3394 = -(((_e3287 + (((_e3292 + (((bitcast<f32>(((_e3274 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3292) * _e3135)) - _e3287) * _e3133)) * _e3344));
let _e3396 = select(-87f, _e3394, (_e3394 > -87f));
let _e3398 = select(88f, _e3396, (_e3396 < 88f));
let _e3400 = ((_e3398 * 1.442695f) + 0.5f);
let _e3402 = select(-127f, _e3400, (_e3400 > -127f));
let _e3404 = select(128f, _e3402, (_e3402 < 128f));
let _e3411 = select(0i, select(select(i32(_e3404), i32(-2147483648), (_e3404 < -2147483600f)), 2147483647i, (_e3404 > 2147483500f)), (_e3404 == _e3404));
let _e3415 = (_e3411 - select(0i, 1i, (_e3404 < f32(_e3411))));
let _e3416 = f32(_e3415);
let _e3420 = ((_e3398 - (_e3416 * 0.6933594f)) - (_e3416 * -2.1219444e-4f));
let _e3442 = -(((_e3324 + (((_e3329 + (((bitcast<f32>((((_e3274 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3329) * _e3135)) - _e3324) * _e3133)) * _e3344));
let _e3444 = select(-87f, _e3442, (_e3442 > -87f));
let _e3446 = select(88f, _e3444, (_e3444 < 88f));
let _e3448 = ((_e3446 * 1.442695f) + 0.5f);
let _e3450 = select(-127f, _e3448, (_e3448 > -127f));
let _e3452 = select(128f, _e3450, (_e3450 < 128f));
let _e3459 = select(0i, select(select(i32(_e3452), i32(-2147483648), (_e3452 < -2147483600f)), 2147483647i, (_e3452 > 2147483500f)), (_e3452 == _e3452));
let _e3463 = (_e3459 - select(0i, 1i, (_e3452 < f32(_e3459))));
let _e3464 = f32(_e3463);
let _e3468 = ((_e3446 - (_e3464 * 0.6933594f)) - (_e3464 * -2.1219444e-4f));
let _e3490 = -(((_e3185 + (((_e3190 + (((bitcast<f32>(((_e3172 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3190) * _e3135)) - _e3185) * _e3133)) * (_e3094 * _e2991.member)));
let _e3492 = select(-87f, _e3490, (_e3490 > -87f));
let _e3494 = select(88f, _e3492, (_e3492 < 88f));
let _e3496 = ((_e3494 * 1.442695f) + 0.5f);
let _e3498 = select(-127f, _e3496, (_e3496 > -127f));
let _e3500 = select(128f, _e3498, (_e3498 < 128f));
let _e3507 = select(0i, select(select(i32(_e3500), i32(-2147483648), (_e3500 < -2147483600f)), 2147483647i, (_e3500 > 2147483500f)), (_e3500 == _e3500));
let _e3511 = (_e3507 - select(0i, 1i, (_e3500 < f32(_e3507))));
let _e3512 = f32(_e3511);
let _e3516 = ((_e3494 - (_e3512 * 0.6933594f)) - (_e3512 * -2.1219444e-4f));
let _e3536 = ((1f + (_e3516 * (1f + (_e3516 * (0.5f + (_e3516 * (0.16666667f + (_e3516 * (0.041666668f + (_e3516 * (0.008333334f + (_e3516 * (0.001388889f + (_e3516 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3511 + 127i)) << bitcast<u32>(23i))));
if _e646 {
let _e3551 = global_1.member.member_24.member_2;
let _e3554 = (_e2431.member_3.x * _e2991.member_2);
let _e3556 = (_e2431.member_3.y * _e2991.member_2);
let _e3558 = (_e2431.member_3.z * _e2991.member_2);
let _e3559 = (0.5f * (_e250 / _e202));
let _e3563 = (_e180 + (_e3554 * _e3559));
let _e3564 = (_e191 + (_e3556 * _e3559));
let _e3565 = (_e202 + (_e3558 * _e3559));
let _e3567 = (2f * _e250);
let _e3569 = ((_e3565 * _e3565) + (_e3567 * _e3558));
let _e3573 = (_e3565 + sqrt(select(0f, _e3569, (_e3569 > 0f))));
let _e3577 = (0.5f * (_e3567 / select(1e-6f, _e3573, (_e3573 > 1e-6f))));
let _e3581 = (_e3563 + (_e3554 * _e3577));
let _e3582 = (_e3564 + (_e3556 * _e3577));
let _e3583 = (_e3565 + (_e3558 * _e3577));
let _e3587 = (_e3551 * _e3551);
let _e3589 = (_e3583 * _e3583);
let _e3597 = (((_e3565 <= 0f) || (_e3569 <= 0f)) || ((_e3583 <= 0f) || (_e3589 <= (_e3587 * (((_e3581 * _e3581) + (_e3582 * _e3582)) + _e3589)))));
let _e3611 = (_e180 + ((_e2431.member_4.x * _e2991.member_2) * _e250));
let _e3612 = (_e191 + ((_e2431.member_4.y * _e2991.member_2) * _e250));
let _e3613 = (_e202 + ((_e2431.member_4.z * _e2991.member_2) * _e250));
let _e3615 = (_e3613 * _e3613);
let _e3624 = ((_e626 & 1u) != 0u);
phi_9703_ = select(select(select(_e3583, _e3565, _e3597), _e3613, _e3624), _e202, _e633);
phi_9704_ = select(select(select(_e3582, _e3564, _e3597), _e3612, _e3624), _e191, _e633);
phi_9705_ = select(select(select(_e3581, _e3563, _e3597), _e3611, _e3624), _e180, _e633);
phi_9706_ = (select(_e3597, ((_e3613 <= 0f) || (_e3615 <= (_e3587 * (((_e3611 * _e3611) + (_e3612 * _e3612)) + _e3615)))), _e3624) && !(_e633));
} else {
phi_9703_ = _e202;
phi_9704_ = _e191;
phi_9705_ = _e180;
phi_9706_ = false;
}
let _e3635 = phi_9703_;
let _e3637 = phi_9704_;
let _e3639 = phi_9705_;
let _e3641 = phi_9706_;
global_6.member[_e126] = (_e137 + _e265);
global_6.member[_e138] = (_e147 + _e272);
global_6.member[_e149] = (_e158 + _e374);
global_6.member[_e160] = (_e169 + _e377);
global_6.member[_e171] = _e3639;
global_6.member[_e182] = _e3637;
global_6.member[_e193] = _e3635;
global_6.member[_e204] = select((_e213 * (((1f + (_e3372 * (1f + (_e3372 * (0.5f + (_e3372 * (0.16666667f + (_e3372 * (0.041666668f + (_e3372 * (0.008333334f + (_e3372 * (0.001388889f + (_e3372 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3367 + 127i)) << bitcast<u32>(23i)))) * _e3536)), _e213, _e633);
global_6.member[_e215] = select((_e224 * (((1f + (_e3420 * (1f + (_e3420 * (0.5f + (_e3420 * (0.16666667f + (_e3420 * (0.041666668f + (_e3420 * (0.008333334f + (_e3420 * (0.001388889f + (_e3420 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3415 + 127i)) << bitcast<u32>(23i)))) * _e3536)), _e224, _e633);
global_6.member[_e226] = select((_e235 * (((1f + (_e3468 * (1f + (_e3468 * (0.5f + (_e3468 * (0.16666667f + (_e3468 * (0.041666668f + (_e3468 * (0.008333334f + (_e3468 * (0.001388889f + (_e3468 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3463 + 127i)) << bitcast<u32>(23i)))) * _e3536)), _e235, _e633);
global_6.member[_e237] = select(_e246, 1f, _e3641);
}
}
}
break;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
