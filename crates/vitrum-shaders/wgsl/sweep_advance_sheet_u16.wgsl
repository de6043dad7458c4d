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
var phi_5874_: type_19;
var phi_7234_: type_20;
var phi_8795_: type_21;
var phi_9819_: f32;
var phi_9820_: f32;
var phi_9821_: f32;
var phi_9822_: bool;
switch bitcast<i32>(0u) {
default: {
let _e87 = global;
let _e90 = arrayLength((&global_2.member));
let _e94 = arrayLength((&global_4.member));
let _e101 = global_1.member.member_1;
let _e104 = (_e87.x + _e101.x);
let _e107 = (_e87.y + _e101.y);
if (_e104 < _e101.z) {
if (_e107 < _e101.w) {
let _e115 = global_1.member.member[0u];
let _e119 = global_1.member.member[1u];
let _e120 = (_e115 * _e119);
let _e122 = ((_e107 * _e115) + _e104);
let _e123 = bitcast<i32>(_e122);
let _e125 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e127 = select(_e125, _e123, (_e123 < _e125));
let _e133 = global_6.member[bitcast<u32>(select(0i, _e127, (_e127 > 0i)))];
let _e134 = (_e120 + _e122);
let _e135 = bitcast<i32>(_e134);
let _e137 = select(_e125, _e135, (_e135 < _e125));
let _e143 = global_6.member[bitcast<u32>(select(0i, _e137, (_e137 > 0i)))];
let _e145 = ((2u * _e120) + _e122);
let _e146 = bitcast<i32>(_e145);
let _e148 = select(_e125, _e146, (_e146 < _e125));
let _e154 = global_6.member[bitcast<u32>(select(0i, _e148, (_e148 > 0i)))];
let _e156 = ((3u * _e120) + _e122);
let _e157 = bitcast<i32>(_e156);
let _e159 = select(_e125, _e157, (_e157 < _e125));
let _e165 = global_6.member[bitcast<u32>(select(0i, _e159, (_e159 > 0i)))];
let _e167 = ((4u * _e120) + _e122);
let _e168 = bitcast<i32>(_e167);
let _e170 = select(_e125, _e168, (_e168 < _e125));
let _e176 = global_6.member[bitcast<u32>(select(0i, _e170, (_e170 > 0i)))];
let _e178 = ((5u * _e120) + _e122);
let _e179 = bitcast<i32>(_e178);
let _e181 = select(_e125, _e179, (_e179 < _e125));
let _e187 = global_6.member[bitcast<u32>(select(0i, _e181, (_e181 > 0i)))];
let _e189 = ((6u * _e120) + _e122);
let _e190 = bitcast<i32>(_e189);
let _e192 = select(_e125, _e190, (_e190 < _e125));
let _e198 = global_6.member[bitcast<u32>(select(0i, _e192, (_e192 > 0i)))];
let _e200 = ((7u * _e120) + _e122);
let _e201 = bitcast<i32>(_e200);
let _e203 = select(_e125, _e201, (_e201 < _e125));
let _e209 = global_6.member[bitcast<u32>(select(0i, _e203, (_e203 > 0i)))];
let _e211 = ((8u * _e120) + _e122);
let _e212 = bitcast<i32>(_e211);
let _e214 = select(_e125, _e212, (_e212 < _e125));
let _e220 = global_6.member[bitcast<u32>(select(0i, _e214, (_e214 > 0i)))];
let _e222 = ((9u * _e120) + _e122);
let _e223 = bitcast<i32>(_e222);
let _e225 = select(_e125, _e223, (_e223 < _e125));
let _e231 = global_6.member[bitcast<u32>(select(0i, _e225, (_e225 > 0i)))];
let _e233 = ((10u * _e120) + _e122);
let _e234 = bitcast<i32>(_e233);
let _e236 = select(_e125, _e234, (_e234 < _e125));
let _e242 = global_6.member[bitcast<u32>(select(0i, _e236, (_e236 > 0i)))];
let _e246 = global_1.member.member_4.member_2;
let _e249 = (1f / select(1e-6f, _e198, (_e198 > 1e-6f)));
let _e253 = global_1.member.member_7.member_3;
let _e254 = (_e246 * _e253);
let _e259 = global_1.member.member_8.member;
let _e261 = (((_e176 * _e249) - _e259) * _e254);
let _e266 = global_1.member.member_8.member_1;
let _e268 = (((_e187 * _e249) - _e266) * _e254);
let _e272 = ((f32(bitcast<i32>(_e104)) - 0.5f) + _e133);
let _e276 = global_1.member.member_2[3u];
let _e277 = (_e276 + 1u);
let _e279 = select(1u, _e277, (_e277 > 0u));
let _e280 = (_e279 == 0u);
if _e280 {
break;
}
let _e285 = ((f32(bitcast<i32>((_e107 % _e279))) - 0.5f) + _e143);
let _e289 = global_1.member.member_4.member;
let _e293 = global_1.member.member_8.member_2;
let _e294 = (_e289 - _e293);
let _e298 = global_1.member.member_7.member;
let _e305 = global_1.member.member_7.member_2;
let _e307 = ((_e298 + (_e259 * _e294)) + ((_e272 + 0.5f) * _e305));
let _e311 = global_1.member.member_7.member_1;
let _e316 = ((_e311 + (_e266 * _e294)) + ((_e285 + 0.5f) * _e305));
let _e322 = global_1.member.member_4.member_1;
let _e323 = (_e322 - _e293);
let _e328 = ((_e298 + (_e259 * _e323)) + (((_e272 + _e261) + 0.5f) * _e305));
let _e333 = ((_e311 + (_e266 * _e323)) + (((_e285 + _e268) + 0.5f) * _e305));
if _e280 {
break;
}
let _e336 = bitcast<i32>(((_e107 / _e279) * 3u));
let _e338 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e340 = select(_e338, _e336, (_e336 < _e338));
let _e346 = global_5.member[bitcast<u32>(select(0i, _e340, (_e340 > 0i)))];
let _e347 = (_e336 + 1i);
let _e349 = select(_e338, _e347, (_e347 < _e338));
let _e355 = global_5.member[bitcast<u32>(select(0i, _e349, (_e349 > 0i)))];
let _e356 = (_e336 + 2i);
let _e358 = select(_e338, _e356, (_e356 < _e338));
let _e364 = global_5.member[bitcast<u32>(select(0i, _e358, (_e358 > 0i)))];
let _e367 = (1f / select(1e-6f, _e364, (_e364 > 1e-6f)));
let _e370 = (((_e346 * _e367) - _e259) * _e254);
let _e373 = (((_e355 * _e367) - _e266) * _e254);
let _e385 = global_1.member.member_5.member;
let _e398 = global_1.member.member_5.member.member_3;
let _e399 = ((((_e385.member * _e307) + (_e385.member_1 * _e316)) + (_e385.member_2 * _e289)) + _e398);
let _e403 = global_1.member.member_5.member_1;
let _e416 = global_1.member.member_5.member_1.member_3;
let _e417 = ((((_e403.member * _e307) + (_e403.member_1 * _e316)) + (_e403.member_2 * _e289)) + _e416);
let _e421 = global_1.member.member_5.member_2;
let _e434 = global_1.member.member_5.member_2.member_3;
let _e435 = ((((_e421.member * _e307) + (_e421.member_1 * _e316)) + (_e421.member_2 * _e289)) + _e434);
let _e441 = ((((_e385.member * _e328) + (_e385.member_1 * _e333)) + (_e385.member_2 * _e322)) + _e398);
let _e447 = ((((_e403.member * _e328) + (_e403.member_1 * _e333)) + (_e403.member_2 * _e322)) + _e416);
let _e453 = ((((_e421.member * _e328) + (_e421.member_1 * _e333)) + (_e421.member_2 * _e322)) + _e434);
let _e458 = global_1.member.member_5.member_3.member_3;
let _e463 = global_1.member.member_5.member_3.member;
let _e464 = (_e463 - 0.5f);
let _e466 = select(-0.5f, _e441, (_e441 > -0.5f));
let _e468 = select(_e464, _e466, (_e466 < _e464));
let _e473 = global_1.member.member_5.member_3.member_1;
let _e474 = (_e473 - 0.5f);
let _e476 = select(-0.5f, _e447, (_e447 > -0.5f));
let _e478 = select(_e474, _e476, (_e476 < _e474));
let _e483 = global_1.member.member_5.member_3.member_2;
let _e484 = (_e483 - 0.5f);
let _e486 = select(-0.5f, _e453, (_e453 > -0.5f));
let _e488 = select(_e484, _e486, (_e486 < _e484));
let _e489 = (_e441 - _e399);
let _e490 = (_e447 - _e417);
let _e491 = (_e453 - _e435);
let _e494 = bitcast<f32>((bitcast<u32>(_e489) & 2147483647u));
let _e497 = bitcast<f32>((bitcast<u32>(_e490) & 2147483647u));
let _e499 = select(_e497, _e494, (_e494 > _e497));
let _e502 = bitcast<f32>((bitcast<u32>(_e491) & 2147483647u));
let _e511 = bitcast<f32>((bitcast<u32>((_e441 - _e468)) & 2147483647u));
let _e514 = bitcast<f32>((bitcast<u32>((_e447 - _e478)) & 2147483647u));
let _e516 = select(_e514, _e511, (_e511 > _e514));
let _e519 = bitcast<f32>((bitcast<u32>((_e453 - _e488)) & 2147483647u));
let _e523 = (_e468 + 0.5f);
let _e524 = (_e463 - 1f);
let _e526 = select(0f, _e523, (_e523 > 0f));
let _e528 = select(_e524, _e526, (_e526 < _e524));
let _e535 = select(0i, select(select(i32(_e528), i32(-2147483648), (_e528 < -2147483600f)), 2147483647i, (_e528 > 2147483500f)), (_e528 == _e528));
let _e544 = global_1.member.member_5.member_7[3u];
let _e545 = (_e544 & 31i);
let _e548 = (_e478 + 0.5f);
let _e549 = (_e473 - 1f);
let _e551 = select(0f, _e548, (_e548 > 0f));
let _e553 = select(_e549, _e551, (_e551 < _e549));
let _e560 = select(0i, select(select(i32(_e553), i32(-2147483648), (_e553 < -2147483600f)), 2147483647i, (_e553 > 2147483500f)), (_e553 == _e553));
let _e567 = (_e488 + 0.5f);
let _e568 = (_e483 - 1f);
let _e570 = select(0f, _e567, (_e567 > 0f));
let _e572 = select(_e568, _e570, (_e570 < _e568));
let _e579 = select(0i, select(select(i32(_e572), i32(-2147483648), (_e572 < -2147483600f)), 2147483647i, (_e572 > 2147483500f)), (_e572 == _e572));
let _e590 = global_1.member.member_5.member_6[3u];
let _e596 = global_1.member.member_5.member_6[0u];
let _e601 = global_1.member.member_5.member_6[1u];
let _e605 = ((_e590 + ((_e535 - select(0i, 1i, (_e528 < f32(_e535)))) >> bitcast<u32>(_e545))) + (_e596 * (((_e560 - select(0i, 1i, (_e553 < f32(_e560)))) >> bitcast<u32>(_e545)) + (_e601 * ((_e579 - select(0i, 1i, (_e572 < f32(_e579)))) >> bitcast<u32>(_e545))))));
let _e607 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e609 = select(_e607, _e605, (_e605 < _e607));
let _e615 = global_3.member[bitcast<u32>(select(0i, _e609, (_e609 > 0i)))];
let _e622 = global_1.member.member[3u];
let _e629 = (((_e622 & 64u) != 0u) || ((((select(_e502, _e499, (_e499 > _e502)) <= _e458) && ((select(_e519, _e516, (_e516 > _e519)) > _e458) || (_e615 != 0u))) && true) && ((_e622 & 32u) != 0u)));
if (select(0u, select(7u, select(3u, 1u, ((((_e261 == 0f) && (_e268 == 0f)) && (_e370 == 0f)) && (_e373 == 0f))), _e629), (_e242 == 0f)) > 1u) {
let _e637 = global_1.member.member[2u];
if _e280 {
break;
}
if _e280 {
break;
}
let _e639 = (_e637 == 2u);
let _e642 = (((_e637 == 1u) || _e639) || (_e637 == 5u));
if _e642 {
let _e1029 = select(-1f, _e468, (_e468 > -1f));
let _e1031 = select(_e463, _e1029, (_e1029 < _e463));
let _e1038 = select(0i, select(select(i32(_e1031), i32(-2147483648), (_e1031 < -2147483600f)), 2147483647i, (_e1031 > 2147483500f)), (_e1031 == _e1031));
let _e1042 = (_e1038 - select(0i, 1i, (_e1031 < f32(_e1038))));
let _e1044 = select(-1f, _e478, (_e478 > -1f));
let _e1046 = select(_e473, _e1044, (_e1044 < _e473));
let _e1053 = select(0i, select(select(i32(_e1046), i32(-2147483648), (_e1046 < -2147483600f)), 2147483647i, (_e1046 > 2147483500f)), (_e1046 == _e1046));
let _e1057 = (_e1053 - select(0i, 1i, (_e1046 < f32(_e1053))));
let _e1059 = select(-1f, _e488, (_e488 > -1f));
let _e1061 = select(_e483, _e1059, (_e1059 < _e483));
let _e1068 = select(0i, select(select(i32(_e1061), i32(-2147483648), (_e1061 < -2147483600f)), 2147483647i, (_e1061 > 2147483500f)), (_e1061 == _e1061));
let _e1072 = (_e1068 - select(0i, 1i, (_e1061 < f32(_e1068))));
let _e1077 = global_1.member.member_5.member_5[0u];
let _e1082 = global_1.member.member_5.member_5[1u];
let _e1090 = (select(0i, select(select(i32(_e473), i32(-2147483648), (_e473 < -2147483600f)), 2147483647i, (_e473 > 2147483500f)), (_e473 == _e473)) - 1i);
let _e1091 = (_e1057 - 1i);
let _e1096 = (_e1057 + 1i);
let _e1099 = (_e1057 + 2i);
let _e1109 = (select(0i, select(select(i32(_e483), i32(-2147483648), (_e483 < -2147483600f)), 2147483647i, (_e483 > 2147483500f)), (_e483 == _e483)) - 1i);
let _e1110 = (_e1072 - 1i);
let _e1115 = (_e1072 + 1i);
let _e1118 = (_e1072 + 2i);
let _e1127 = select(0i, select(select(i32(_e463), i32(-2147483648), (_e463 < -2147483600f)), 2147483647i, (_e463 > 2147483500f)), (_e463 == _e463));
let _e1128 = (_e1127 - 1i);
let _e1129 = (_e1042 - 1i);
let _e1131 = select(0i, _e1129, (_e1129 > 0i));
let _e1133 = select(0i, _e1042, (_e1042 > 0i));
let _e1134 = (_e1042 + 1i);
let _e1136 = select(_e1128, _e1134, (_e1134 < _e1128));
let _e1137 = (_e1042 + 2i);
let _e1140 = (_e1127 - 2i);
let _e1142 = select(0i, _e1140, (_e1140 > 0i));
let _e1144 = select(_e1142, _e1131, (_e1131 < _e1142));
let _e1146 = select(_e1142, _e1133, (_e1133 < _e1142));
let _e1148 = select(_e1142, _e1136, (_e1136 < _e1142));
let _e1167 = (select(0i, _e1091, (_e1091 > 0i)) * _e1077);
let _e1168 = (select(0i, _e1057, (_e1057 > 0i)) * _e1077);
let _e1169 = (select(_e1090, _e1096, (_e1096 < _e1090)) * _e1077);
let _e1170 = (select(_e1090, _e1099, (_e1099 < _e1090)) * _e1077);
let _e1171 = (select(0i, _e1110, (_e1110 > 0i)) * _e1082);
let _e1172 = (select(0i, _e1072, (_e1072 > 0i)) * _e1082);
let _e1173 = (select(_e1109, _e1115, (_e1115 < _e1109)) * _e1082);
let _e1174 = (select(_e1109, _e1118, (_e1118 < _e1109)) * _e1082);
local_4 = type_18(array<i32, 4>(_e1144, _e1146, _e1148, 0i), array<u32, 6>(bitcast<u32>(((_e1131 - _e1144) * 16i)), bitcast<u32>(((_e1133 - _e1144) * 16i)), bitcast<u32>(((_e1133 - _e1146) * 16i)), bitcast<u32>(((_e1136 - _e1146) * 16i)), bitcast<u32>(((_e1136 - _e1148) * 16i)), bitcast<u32>(((select(_e1128, _e1137, (_e1137 < _e1128)) - _e1148) * 16i))));
local_5 = vec3<f32>((_e468 - f32(_e1042)), (_e478 - f32(_e1057)), (_e488 - f32(_e1072)));
let _e1186 = (_e1172 + _e1168);
let _e1189 = local_4.member[0u];
let _e1190 = (_e1186 + _e1189);
let _e1192 = (_e1190 >> bitcast<u32>(1i));
let _e1195 = bitcast<u32>(((_e1190 & 1i) * 16i));
let _e1197 = (bitcast<i32>(_e90) - 1i);
let _e1199 = select(_e1197, _e1192, (_e1192 < _e1197));
let _e1204 = global_2.member[bitcast<u32>(select(0i, _e1199, (_e1199 > 0i)))];
let _e1208 = (_e1192 + 1i);
let _e1210 = select(_e1197, _e1208, (_e1208 < _e1197));
let _e1215 = global_2.member[bitcast<u32>(select(0i, _e1210, (_e1210 > 0i)))];
let _e1222 = ((_e1204 >> bitcast<u32>((_e1195 & 31u))) | ((_e1215 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1195) & 31u))));
let _e1225 = local_4.member[2u];
let _e1226 = (_e1186 + _e1225);
let _e1228 = (_e1226 >> bitcast<u32>(1i));
let _e1231 = bitcast<u32>(((_e1226 & 1i) * 16i));
let _e1233 = select(_e1197, _e1228, (_e1228 < _e1197));
let _e1238 = global_2.member[bitcast<u32>(select(0i, _e1233, (_e1233 > 0i)))];
let _e1242 = (_e1228 + 1i);
let _e1244 = select(_e1197, _e1242, (_e1242 < _e1197));
let _e1249 = global_2.member[bitcast<u32>(select(0i, _e1244, (_e1244 > 0i)))];
let _e1256 = ((_e1238 >> bitcast<u32>((_e1231 & 31u))) | ((_e1249 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1231) & 31u))));
let _e1259 = local_4.member_1[0u];
let _e1265 = f32(bitcast<i32>(((_e1222 >> bitcast<u32>((_e1259 & 31u))) & 65535u)));
let _e1268 = local_4.member_1[1u];
let _e1274 = f32(bitcast<i32>(((_e1222 >> bitcast<u32>((_e1268 & 31u))) & 65535u)));
let _e1277 = local_4.member_1[4u];
let _e1283 = f32(bitcast<i32>(((_e1256 >> bitcast<u32>((_e1277 & 31u))) & 65535u)));
let _e1286 = local_4.member_1[5u];
let _e1293 = local_5[0u];
let _e1296 = (_e1265 + ((_e1274 - _e1265) * _e1293));
let _e1297 = local_5[0u];
let _e1300 = (_e1274 + ((_e1283 - _e1274) * _e1297));
let _e1301 = local_5[0u];
let _e1304 = (_e1283 + ((f32(bitcast<i32>(((_e1256 >> bitcast<u32>((_e1286 & 31u))) & 65535u))) - _e1283) * _e1301));
let _e1305 = (_e1172 + _e1169);
let _e1306 = local_4.member[0u];
let _e1307 = (_e1305 + _e1306);
let _e1309 = (_e1307 >> bitcast<u32>(1i));
let _e1312 = bitcast<u32>(((_e1307 & 1i) * 16i));
let _e1314 = select(_e1197, _e1309, (_e1309 < _e1197));
let _e1319 = global_2.member[bitcast<u32>(select(0i, _e1314, (_e1314 > 0i)))];
let _e1323 = (_e1309 + 1i);
let _e1325 = select(_e1197, _e1323, (_e1323 < _e1197));
let _e1330 = global_2.member[bitcast<u32>(select(0i, _e1325, (_e1325 > 0i)))];
let _e1337 = ((_e1319 >> bitcast<u32>((_e1312 & 31u))) | ((_e1330 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1312) & 31u))));
let _e1338 = local_4.member[2u];
let _e1339 = (_e1305 + _e1338);
let _e1341 = (_e1339 >> bitcast<u32>(1i));
let _e1344 = bitcast<u32>(((_e1339 & 1i) * 16i));
let _e1346 = select(_e1197, _e1341, (_e1341 < _e1197));
let _e1351 = global_2.member[bitcast<u32>(select(0i, _e1346, (_e1346 > 0i)))];
let _e1355 = (_e1341 + 1i);
let _e1357 = select(_e1197, _e1355, (_e1355 < _e1197));
let _e1362 = global_2.member[bitcast<u32>(select(0i, _e1357, (_e1357 > 0i)))];
let _e1369 = ((_e1351 >> bitcast<u32>((_e1344 & 31u))) | ((_e1362 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1344) & 31u))));
let _e1370 = local_4.member_1[0u];
let _e1376 = f32(bitcast<i32>(((_e1337 >> bitcast<u32>((_e1370 & 31u))) & 65535u)));
let _e1377 = local_4.member_1[1u];
let _e1383 = f32(bitcast<i32>(((_e1337 >> bitcast<u32>((_e1377 & 31u))) & 65535u)));
let _e1384 = local_4.member_1[4u];
let _e1390 = f32(bitcast<i32>(((_e1369 >> bitcast<u32>((_e1384 & 31u))) & 65535u)));
let _e1391 = local_4.member_1[5u];
let _e1398 = local_5[0u];
let _e1402 = local_5[0u];
let _e1405 = (_e1383 + ((_e1390 - _e1383) * _e1402));
let _e1406 = local_5[0u];
let _e1410 = (_e1173 + _e1168);
let _e1411 = local_4.member[0u];
let _e1412 = (_e1410 + _e1411);
let _e1414 = (_e1412 >> bitcast<u32>(1i));
let _e1417 = bitcast<u32>(((_e1412 & 1i) * 16i));
let _e1419 = select(_e1197, _e1414, (_e1414 < _e1197));
let _e1424 = global_2.member[bitcast<u32>(select(0i, _e1419, (_e1419 > 0i)))];
let _e1428 = (_e1414 + 1i);
let _e1430 = select(_e1197, _e1428, (_e1428 < _e1197));
let _e1435 = global_2.member[bitcast<u32>(select(0i, _e1430, (_e1430 > 0i)))];
let _e1442 = ((_e1424 >> bitcast<u32>((_e1417 & 31u))) | ((_e1435 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1417) & 31u))));
let _e1443 = local_4.member[2u];
let _e1444 = (_e1410 + _e1443);
let _e1446 = (_e1444 >> bitcast<u32>(1i));
let _e1449 = bitcast<u32>(((_e1444 & 1i) * 16i));
let _e1451 = select(_e1197, _e1446, (_e1446 < _e1197));
let _e1456 = global_2.member[bitcast<u32>(select(0i, _e1451, (_e1451 > 0i)))];
let _e1460 = (_e1446 + 1i);
let _e1462 = select(_e1197, _e1460, (_e1460 < _e1197));
let _e1467 = global_2.member[bitcast<u32>(select(0i, _e1462, (_e1462 > 0i)))];
let _e1474 = ((_e1456 >> bitcast<u32>((_e1449 & 31u))) | ((_e1467 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1449) & 31u))));
let _e1475 = local_4.member_1[0u];
let _e1481 = f32(bitcast<i32>(((_e1442 >> bitcast<u32>((_e1475 & 31u))) & 65535u)));
let _e1482 = local_4.member_1[1u];
let _e1488 = f32(bitcast<i32>(((_e1442 >> bitcast<u32>((_e1482 & 31u))) & 65535u)));
let _e1489 = local_4.member_1[4u];
let _e1495 = f32(bitcast<i32>(((_e1474 >> bitcast<u32>((_e1489 & 31u))) & 65535u)));
let _e1496 = local_4.member_1[5u];
let _e1503 = local_5[0u];
let _e1506 = (_e1481 + ((_e1488 - _e1481) * _e1503));
let _e1507 = local_5[0u];
let _e1510 = (_e1488 + ((_e1495 - _e1488) * _e1507));
let _e1511 = local_5[0u];
let _e1514 = (_e1495 + ((f32(bitcast<i32>(((_e1474 >> bitcast<u32>((_e1496 & 31u))) & 65535u))) - _e1495) * _e1511));
let _e1515 = (_e1173 + _e1169);
let _e1516 = local_4.member[0u];
let _e1517 = (_e1515 + _e1516);
let _e1519 = (_e1517 >> bitcast<u32>(1i));
let _e1522 = bitcast<u32>(((_e1517 & 1i) * 16i));
let _e1524 = select(_e1197, _e1519, (_e1519 < _e1197));
let _e1529 = global_2.member[bitcast<u32>(select(0i, _e1524, (_e1524 > 0i)))];
let _e1533 = (_e1519 + 1i);
let _e1535 = select(_e1197, _e1533, (_e1533 < _e1197));
let _e1540 = global_2.member[bitcast<u32>(select(0i, _e1535, (_e1535 > 0i)))];
let _e1547 = ((_e1529 >> bitcast<u32>((_e1522 & 31u))) | ((_e1540 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1522) & 31u))));
let _e1548 = local_4.member[2u];
let _e1549 = (_e1515 + _e1548);
let _e1551 = (_e1549 >> bitcast<u32>(1i));
let _e1554 = bitcast<u32>(((_e1549 & 1i) * 16i));
let _e1556 = select(_e1197, _e1551, (_e1551 < _e1197));
let _e1561 = global_2.member[bitcast<u32>(select(0i, _e1556, (_e1556 > 0i)))];
let _e1565 = (_e1551 + 1i);
let _e1567 = select(_e1197, _e1565, (_e1565 < _e1197));
let _e1572 = global_2.member[bitcast<u32>(select(0i, _e1567, (_e1567 > 0i)))];
let _e1579 = ((_e1561 >> bitcast<u32>((_e1554 & 31u))) | ((_e1572 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1554) & 31u))));
let _e1580 = local_4.member_1[0u];
let _e1586 = f32(bitcast<i32>(((_e1547 >> bitcast<u32>((_e1580 & 31u))) & 65535u)));
let _e1587 = local_4.member_1[1u];
let _e1593 = f32(bitcast<i32>(((_e1547 >> bitcast<u32>((_e1587 & 31u))) & 65535u)));
let _e1594 = local_4.member_1[4u];
let _e1600 = f32(bitcast<i32>(((_e1579 >> bitcast<u32>((_e1594 & 31u))) & 65535u)));
let _e1601 = local_4.member_1[5u];
let _e1608 = local_5[0u];
let _e1612 = local_5[0u];
let _e1615 = (_e1593 + ((_e1600 - _e1593) * _e1612));
let _e1616 = local_5[0u];
let _e1623 = local_4.member[1u];
let _e1624 = ((_e1172 + _e1167) + _e1623);
let _e1626 = (_e1624 >> bitcast<u32>(1i));
let _e1629 = bitcast<u32>(((_e1624 & 1i) * 16i));
let _e1631 = select(_e1197, _e1626, (_e1626 < _e1197));
let _e1636 = global_2.member[bitcast<u32>(select(0i, _e1631, (_e1631 > 0i)))];
let _e1640 = (_e1626 + 1i);
let _e1642 = select(_e1197, _e1640, (_e1640 < _e1197));
let _e1647 = global_2.member[bitcast<u32>(select(0i, _e1642, (_e1642 > 0i)))];
let _e1654 = ((_e1636 >> bitcast<u32>((_e1629 & 31u))) | ((_e1647 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1629) & 31u))));
let _e1657 = local_4.member_1[2u];
let _e1663 = f32(bitcast<i32>(((_e1654 >> bitcast<u32>((_e1657 & 31u))) & 65535u)));
let _e1666 = local_4.member_1[3u];
let _e1673 = local_5[0u];
let _e1676 = (_e1663 + ((f32(bitcast<i32>(((_e1654 >> bitcast<u32>((_e1666 & 31u))) & 65535u))) - _e1663) * _e1673));
let _e1678 = local_4.member[1u];
let _e1679 = ((_e1172 + _e1170) + _e1678);
let _e1681 = (_e1679 >> bitcast<u32>(1i));
let _e1684 = bitcast<u32>(((_e1679 & 1i) * 16i));
let _e1686 = select(_e1197, _e1681, (_e1681 < _e1197));
let _e1691 = global_2.member[bitcast<u32>(select(0i, _e1686, (_e1686 > 0i)))];
let _e1695 = (_e1681 + 1i);
let _e1697 = select(_e1197, _e1695, (_e1695 < _e1197));
let _e1702 = global_2.member[bitcast<u32>(select(0i, _e1697, (_e1697 > 0i)))];
let _e1709 = ((_e1691 >> bitcast<u32>((_e1684 & 31u))) | ((_e1702 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1684) & 31u))));
let _e1710 = local_4.member_1[2u];
let _e1716 = f32(bitcast<i32>(((_e1709 >> bitcast<u32>((_e1710 & 31u))) & 65535u)));
let _e1717 = local_4.member_1[3u];
let _e1724 = local_5[0u];
let _e1729 = local_4.member[1u];
let _e1730 = ((_e1173 + _e1167) + _e1729);
let _e1732 = (_e1730 >> bitcast<u32>(1i));
let _e1735 = bitcast<u32>(((_e1730 & 1i) * 16i));
let _e1737 = select(_e1197, _e1732, (_e1732 < _e1197));
let _e1742 = global_2.member[bitcast<u32>(select(0i, _e1737, (_e1737 > 0i)))];
let _e1746 = (_e1732 + 1i);
let _e1748 = select(_e1197, _e1746, (_e1746 < _e1197));
let _e1753 = global_2.member[bitcast<u32>(select(0i, _e1748, (_e1748 > 0i)))];
let _e1760 = ((_e1742 >> bitcast<u32>((_e1735 & 31u))) | ((_e1753 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1735) & 31u))));
let _e1761 = local_4.member_1[2u];
let _e1767 = f32(bitcast<i32>(((_e1760 >> bitcast<u32>((_e1761 & 31u))) & 65535u)));
let _e1768 = local_4.member_1[3u];
let _e1775 = local_5[0u];
let _e1778 = (_e1767 + ((f32(bitcast<i32>(((_e1760 >> bitcast<u32>((_e1768 & 31u))) & 65535u))) - _e1767) * _e1775));
let _e1780 = local_4.member[1u];
let _e1781 = ((_e1173 + _e1170) + _e1780);
let _e1783 = (_e1781 >> bitcast<u32>(1i));
let _e1786 = bitcast<u32>(((_e1781 & 1i) * 16i));
let _e1788 = select(_e1197, _e1783, (_e1783 < _e1197));
let _e1793 = global_2.member[bitcast<u32>(select(0i, _e1788, (_e1788 > 0i)))];
let _e1797 = (_e1783 + 1i);
let _e1799 = select(_e1197, _e1797, (_e1797 < _e1197));
let _e1804 = global_2.member[bitcast<u32>(select(0i, _e1799, (_e1799 > 0i)))];
let _e1811 = ((_e1793 >> bitcast<u32>((_e1786 & 31u))) | ((_e1804 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1786) & 31u))));
let _e1812 = local_4.member_1[2u];
let _e1818 = f32(bitcast<i32>(((_e1811 >> bitcast<u32>((_e1812 & 31u))) & 65535u)));
let _e1819 = local_4.member_1[3u];
let _e1826 = local_5[0u];
let _e1831 = local_4.member[1u];
let _e1832 = ((_e1171 + _e1168) + _e1831);
let _e1834 = (_e1832 >> bitcast<u32>(1i));
let _e1837 = bitcast<u32>(((_e1832 & 1i) * 16i));
let _e1839 = select(_e1197, _e1834, (_e1834 < _e1197));
let _e1844 = global_2.member[bitcast<u32>(select(0i, _e1839, (_e1839 > 0i)))];
let _e1848 = (_e1834 + 1i);
let _e1850 = select(_e1197, _e1848, (_e1848 < _e1197));
let _e1855 = global_2.member[bitcast<u32>(select(0i, _e1850, (_e1850 > 0i)))];
let _e1862 = ((_e1844 >> bitcast<u32>((_e1837 & 31u))) | ((_e1855 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1837) & 31u))));
let _e1863 = local_4.member_1[2u];
let _e1869 = f32(bitcast<i32>(((_e1862 >> bitcast<u32>((_e1863 & 31u))) & 65535u)));
let _e1870 = local_4.member_1[3u];
let _e1877 = local_5[0u];
let _e1880 = (_e1869 + ((f32(bitcast<i32>(((_e1862 >> bitcast<u32>((_e1870 & 31u))) & 65535u))) - _e1869) * _e1877));
let _e1882 = local_4.member[1u];
let _e1883 = ((_e1174 + _e1168) + _e1882);
let _e1885 = (_e1883 >> bitcast<u32>(1i));
let _e1888 = bitcast<u32>(((_e1883 & 1i) * 16i));
let _e1890 = select(_e1197, _e1885, (_e1885 < _e1197));
let _e1895 = global_2.member[bitcast<u32>(select(0i, _e1890, (_e1890 > 0i)))];
let _e1899 = (_e1885 + 1i);
let _e1901 = select(_e1197, _e1899, (_e1899 < _e1197));
let _e1906 = global_2.member[bitcast<u32>(select(0i, _e1901, (_e1901 > 0i)))];
let _e1913 = ((_e1895 >> bitcast<u32>((_e1888 & 31u))) | ((_e1906 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1888) & 31u))));
let _e1914 = local_4.member_1[2u];
let _e1920 = f32(bitcast<i32>(((_e1913 >> bitcast<u32>((_e1914 & 31u))) & 65535u)));
let _e1921 = local_4.member_1[3u];
let _e1928 = local_5[0u];
let _e1931 = (_e1920 + ((f32(bitcast<i32>(((_e1913 >> bitcast<u32>((_e1921 & 31u))) & 65535u))) - _e1920) * _e1928));
let _e1933 = local_4.member[1u];
let _e1934 = ((_e1171 + _e1169) + _e1933);
let _e1936 = (_e1934 >> bitcast<u32>(1i));
let _e1939 = bitcast<u32>(((_e1934 & 1i) * 16i));
let _e1941 = select(_e1197, _e1936, (_e1936 < _e1197));
let _e1946 = global_2.member[bitcast<u32>(select(0i, _e1941, (_e1941 > 0i)))];
let _e1950 = (_e1936 + 1i);
let _e1952 = select(_e1197, _e1950, (_e1950 < _e1197));
let _e1957 = global_2.member[bitcast<u32>(select(0i, _e1952, (_e1952 > 0i)))];
let _e1964 = ((_e1946 >> bitcast<u32>((_e1939 & 31u))) | ((_e1957 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1939) & 31u))));
let _e1965 = local_4.member_1[2u];
let _e1971 = f32(bitcast<i32>(((_e1964 >> bitcast<u32>((_e1965 & 31u))) & 65535u)));
let _e1972 = local_4.member_1[3u];
let _e1979 = local_5[0u];
let _e1984 = local_4.member[1u];
let _e1985 = ((_e1174 + _e1169) + _e1984);
let _e1987 = (_e1985 >> bitcast<u32>(1i));
let _e1990 = bitcast<u32>(((_e1985 & 1i) * 16i));
let _e1992 = select(_e1197, _e1987, (_e1987 < _e1197));
let _e1997 = global_2.member[bitcast<u32>(select(0i, _e1992, (_e1992 > 0i)))];
let _e2001 = (_e1987 + 1i);
let _e2003 = select(_e1197, _e2001, (_e2001 < _e1197));
let _e2008 = global_2.member[bitcast<u32>(select(0i, _e2003, (_e2003 > 0i)))];
let _e2015 = ((_e1997 >> bitcast<u32>((_e1990 & 31u))) | ((_e2008 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1990) & 31u))));
let _e2016 = local_4.member_1[2u];
let _e2022 = f32(bitcast<i32>(((_e2015 >> bitcast<u32>((_e2016 & 31u))) & 65535u)));
let _e2023 = local_4.member_1[3u];
let _e2030 = local_5[0u];
let _e2035 = local_5[1u];
let _e2038 = (_e1300 + ((_e1405 - _e1300) * _e2035));
let _e2039 = local_5[1u];
let _e2042 = (_e1510 + ((_e1615 - _e1510) * _e2039));
let _e2043 = local_5[1u];
let _e2046 = (_e1296 + (((_e1376 + ((_e1383 - _e1376) * _e1398)) - _e1296) * _e2043));
let _e2047 = local_5[1u];
let _e2052 = local_5[2u];
let _e2056 = local_5[1u];
let _e2059 = (_e1304 + (((_e1390 + ((f32(bitcast<i32>(((_e1369 >> bitcast<u32>((_e1391 & 31u))) & 65535u))) - _e1390) * _e1406)) - _e1304) * _e2056));
let _e2060 = local_5[1u];
let _e2064 = local_5[2u];
let _e2068 = local_5[1u];
let _e2071 = (_e1676 + ((_e1300 - _e1676) * _e2068));
let _e2072 = local_5[1u];
let _e2076 = local_5[2u];
let _e2080 = local_5[1u];
let _e2083 = (_e1405 + (((_e1716 + ((f32(bitcast<i32>(((_e1709 >> bitcast<u32>((_e1717 & 31u))) & 65535u))) - _e1716) * _e1724)) - _e1405) * _e2080));
let _e2084 = local_5[1u];
let _e2088 = local_5[2u];
let _e2092 = local_5[1u];
let _e2095 = (_e1880 + (((_e1971 + ((f32(bitcast<i32>(((_e1964 >> bitcast<u32>((_e1972 & 31u))) & 65535u))) - _e1971) * _e1979)) - _e1880) * _e2092));
let _e2096 = local_5[2u];
let _e2100 = local_5[1u];
let _e2104 = local_5[2u];
let _e2108 = local_5[2u];
let _e2116 = global_1.member.member_5.member_4.member;
let _e2122 = global_1.member.member_5.member_4.member_1;
let _e2123 = (((_e2038 + ((_e2042 - _e2038) * _e2108)) * _e2116) + _e2122);
let _e2125 = select(0f, _e2123, (_e2123 > 0f));
let _e2127 = select(1f, _e2125, (_e2125 < 1f));
let _e2129 = (((_e2046 + (((_e1506 + (((_e1586 + ((_e1593 - _e1586) * _e1608)) - _e1506) * _e2047)) - _e2046) * _e2052)) * _e2116) + _e2122);
let _e2131 = select(0f, _e2129, (_e2129 > 0f));
let _e2133 = select(1f, _e2131, (_e2131 < 1f));
let _e2135 = (((_e2059 + (((_e1514 + (((_e1600 + ((f32(bitcast<i32>(((_e1579 >> bitcast<u32>((_e1601 & 31u))) & 65535u))) - _e1600) * _e1616)) - _e1514) * _e2060)) - _e2059) * _e2064)) * _e2116) + _e2122);
let _e2137 = select(0f, _e2135, (_e2135 > 0f));
let _e2139 = select(1f, _e2137, (_e2137 < 1f));
let _e2141 = (((_e2071 + (((_e1778 + ((_e1510 - _e1778) * _e2072)) - _e2071) * _e2076)) * _e2116) + _e2122);
let _e2143 = select(0f, _e2141, (_e2141 > 0f));
let _e2145 = select(1f, _e2143, (_e2143 < 1f));
let _e2147 = (((_e2083 + (((_e1615 + (((_e1818 + ((f32(bitcast<i32>(((_e1811 >> bitcast<u32>((_e1819 & 31u))) & 65535u))) - _e1818) * _e1826)) - _e1615) * _e2084)) - _e2083) * _e2088)) * _e2116) + _e2122);
let _e2149 = select(0f, _e2147, (_e2147 > 0f));
let _e2151 = select(1f, _e2149, (_e2149 < 1f));
let _e2153 = (((_e2095 + ((_e2038 - _e2095) * _e2096)) * _e2116) + _e2122);
let _e2155 = select(0f, _e2153, (_e2153 > 0f));
let _e2157 = select(1f, _e2155, (_e2155 < 1f));
let _e2159 = (((_e2042 + (((_e1931 + (((_e2022 + ((f32(bitcast<i32>(((_e2015 >> bitcast<u32>((_e2023 & 31u))) & 65535u))) - _e2022) * _e2030)) - _e1931) * _e2100)) - _e2042) * _e2104)) * _e2116) + _e2122);
let _e2161 = select(0f, _e2159, (_e2159 > 0f));
let _e2163 = select(1f, _e2161, (_e2161 < 1f));
let _e2164 = (_e2127 * 1024f);
let _e2165 = (1024f - 1f);
let _e2167 = select(0f, _e2164, (_e2164 > 0f));
let _e2169 = select(_e2165, _e2167, (_e2167 < _e2165));
let _e2176 = select(0i, select(select(i32(_e2169), i32(-2147483648), (_e2169 < -2147483600f)), 2147483647i, (_e2169 > 2147483500f)), (_e2169 == _e2169));
let _e2180 = (_e2176 - select(0i, 1i, (_e2169 < f32(_e2176))));
let _e2181 = (262147i + _e2180);
let _e2183 = (bitcast<i32>(_e94) - 1i);
let _e2185 = select(_e2183, _e2181, (_e2181 < _e2183));
let _e2191 = global_4.member[bitcast<u32>(select(0i, _e2185, (_e2185 > 0i)))];
let _e2201 = select(_e2183, 262146i, (262146i < _e2183));
let _e2207 = global_4.member[bitcast<u32>(select(0i, _e2201, (_e2201 > 0i)))];
let _e2208 = bitcast<f32>(_e2207);
let _e2209 = (f32((bitcast<i32>((_e2191 & 4095u)) - 2048i)) * _e2208);
let _e2211 = select(_e2183, 262144i, (262144i < _e2183));
let _e2217 = global_4.member[bitcast<u32>(select(0i, _e2211, (_e2211 > 0i)))];
let _e2218 = bitcast<f32>(_e2217);
let _e2220 = select(_e2183, 262145i, (262145i < _e2183));
let _e2226 = global_4.member[bitcast<u32>(select(0i, _e2220, (_e2220 > 0i)))];
let _e2227 = bitcast<f32>(_e2226);
let _e2233 = ((_e2218 + (f32(bitcast<i32>((_e2191 >> bitcast<u32>(12u)))) * _e2227)) + (_e2209 * (_e2164 - f32(_e2180))));
let _e2234 = (_e2209 * 1024f);
if _e639 {
let _e2499 = ((0.5f * (_e2139 - _e2133)) * _e2234);
let _e2500 = ((0.5f * (_e2151 - _e2145)) * _e2234);
let _e2501 = ((0.5f * (_e2163 - _e2157)) * _e2234);
phi_5874_ = type_19(_e2233, vec3<f32>(_e2499, _e2500, _e2501), vec3<f32>((_e2499 * _e2233), (_e2500 * _e2233), (_e2501 * _e2233)));
} else {
let _e2235 = (_e2133 * 1024f);
let _e2237 = select(0f, _e2235, (_e2235 > 0f));
let _e2239 = select(_e2165, _e2237, (_e2237 < _e2165));
let _e2246 = select(0i, select(select(i32(_e2239), i32(-2147483648), (_e2239 < -2147483600f)), 2147483647i, (_e2239 > 2147483500f)), (_e2239 == _e2239));
let _e2250 = (_e2246 - select(0i, 1i, (_e2239 < f32(_e2246))));
let _e2251 = (262147i + _e2250);
let _e2253 = select(_e2183, _e2251, (_e2251 < _e2183));
let _e2259 = global_4.member[bitcast<u32>(select(0i, _e2253, (_e2253 > 0i)))];
let _e2274 = ((_e2218 + (f32(bitcast<i32>((_e2259 >> bitcast<u32>(12u)))) * _e2227)) + ((f32((bitcast<i32>((_e2259 & 4095u)) - 2048i)) * _e2208) * (_e2235 - f32(_e2250))));
let _e2275 = (_e2139 * 1024f);
let _e2277 = select(0f, _e2275, (_e2275 > 0f));
let _e2279 = select(_e2165, _e2277, (_e2277 < _e2165));
let _e2286 = select(0i, select(select(i32(_e2279), i32(-2147483648), (_e2279 < -2147483600f)), 2147483647i, (_e2279 > 2147483500f)), (_e2279 == _e2279));
let _e2290 = (_e2286 - select(0i, 1i, (_e2279 < f32(_e2286))));
let _e2291 = (262147i + _e2290);
let _e2293 = select(_e2183, _e2291, (_e2291 < _e2183));
let _e2299 = global_4.member[bitcast<u32>(select(0i, _e2293, (_e2293 > 0i)))];
let _e2314 = ((_e2218 + (f32(bitcast<i32>((_e2299 >> bitcast<u32>(12u)))) * _e2227)) + ((f32((bitcast<i32>((_e2299 & 4095u)) - 2048i)) * _e2208) * (_e2275 - f32(_e2290))));
let _e2315 = (_e2145 * 1024f);
let _e2317 = select(0f, _e2315, (_e2315 > 0f));
let _e2319 = select(_e2165, _e2317, (_e2317 < _e2165));
let _e2326 = select(0i, select(select(i32(_e2319), i32(-2147483648), (_e2319 < -2147483600f)), 2147483647i, (_e2319 > 2147483500f)), (_e2319 == _e2319));
let _e2330 = (_e2326 - select(0i, 1i, (_e2319 < f32(_e2326))));
let _e2331 = (262147i + _e2330);
let _e2333 = select(_e2183, _e2331, (_e2331 < _e2183));
let _e2339 = global_4.member[bitcast<u32>(select(0i, _e2333, (_e2333 > 0i)))];
let _e2354 = ((_e2218 + (f32(bitcast<i32>((_e2339 >> bitcast<u32>(12u)))) * _e2227)) + ((f32((bitcast<i32>((_e2339 & 4095u)) - 2048i)) * _e2208) * (_e2315 - f32(_e2330))));
let _e2355 = (_e2151 * 1024f);
let _e2357 = select(0f, _e2355, (_e2355 > 0f));
let _e2359 = select(_e2165, _e2357, (_e2357 < _e2165));
let _e2366 = select(0i, select(select(i32(_e2359), i32(-2147483648), (_e2359 < -2147483600f)), 2147483647i, (_e2359 > 2147483500f)), (_e2359 == _e2359));
let _e2370 = (_e2366 - select(0i, 1i, (_e2359 < f32(_e2366))));
let _e2371 = (262147i + _e2370);
let _e2373 = select(_e2183, _e2371, (_e2371 < _e2183));
let _e2379 = global_4.member[bitcast<u32>(select(0i, _e2373, (_e2373 > 0i)))];
let _e2394 = ((_e2218 + (f32(bitcast<i32>((_e2379 >> bitcast<u32>(12u)))) * _e2227)) + ((f32((bitcast<i32>((_e2379 & 4095u)) - 2048i)) * _e2208) * (_e2355 - f32(_e2370))));
let _e2395 = (_e2157 * 1024f);
let _e2397 = select(0f, _e2395, (_e2395 > 0f));
let _e2399 = select(_e2165, _e2397, (_e2397 < _e2165));
let _e2406 = select(0i, select(select(i32(_e2399), i32(-2147483648), (_e2399 < -2147483600f)), 2147483647i, (_e2399 > 2147483500f)), (_e2399 == _e2399));
let _e2410 = (_e2406 - select(0i, 1i, (_e2399 < f32(_e2406))));
let _e2411 = (262147i + _e2410);
let _e2413 = select(_e2183, _e2411, (_e2411 < _e2183));
let _e2419 = global_4.member[bitcast<u32>(select(0i, _e2413, (_e2413 > 0i)))];
let _e2434 = ((_e2218 + (f32(bitcast<i32>((_e2419 >> bitcast<u32>(12u)))) * _e2227)) + ((f32((bitcast<i32>((_e2419 & 4095u)) - 2048i)) * _e2208) * (_e2395 - f32(_e2410))));
let _e2435 = (_e2163 * 1024f);
let _e2437 = select(0f, _e2435, (_e2435 > 0f));
let _e2439 = select(_e2165, _e2437, (_e2437 < _e2165));
let _e2446 = select(0i, select(select(i32(_e2439), i32(-2147483648), (_e2439 < -2147483600f)), 2147483647i, (_e2439 > 2147483500f)), (_e2439 == _e2439));
let _e2450 = (_e2446 - select(0i, 1i, (_e2439 < f32(_e2446))));
let _e2451 = (262147i + _e2450);
let _e2453 = select(_e2183, _e2451, (_e2451 < _e2183));
let _e2459 = global_4.member[bitcast<u32>(select(0i, _e2453, (_e2453 > 0i)))];
let _e2474 = ((_e2218 + (f32(bitcast<i32>((_e2459 >> bitcast<u32>(12u)))) * _e2227)) + ((f32((bitcast<i32>((_e2459 & 4095u)) - 2048i)) * _e2208) * (_e2435 - f32(_e2450))));
let _e2475 = (_e2314 - _e2274);
let _e2477 = (_e2394 - _e2354);
let _e2479 = (_e2474 - _e2434);
phi_5874_ = type_19(_e2233, vec3<f32>((0.5f * _e2475), (0.5f * _e2477), (0.5f * _e2479)), vec3<f32>((0.25f * (_e2475 * (_e2314 + _e2274))), (0.25f * (_e2477 * (_e2394 + _e2354))), (0.25f * (_e2479 * (_e2474 + _e2434)))));
}
let _e2509 = phi_5874_;
let _e2524 = select(0f, 1f, ((((((_e441 >= -0.5f) && (_e441 <= _e464)) && (_e447 >= -0.5f)) && (_e447 <= _e474)) && (_e453 >= -0.5f)) && (_e453 <= _e484)));
let _e2526 = (0.5f * (_e2139 - _e2133));
let _e2528 = (0.5f * (_e2151 - _e2145));
let _e2530 = (0.5f * (_e2163 - _e2157));
let _e2535 = global_1.member.member_5.member.member;
let _e2541 = global_1.member.member_5.member_1.member;
let _e2548 = global_1.member.member_5.member_2.member;
let _e2555 = global_1.member.member_5.member.member_1;
let _e2561 = global_1.member.member_5.member_1.member_1;
let _e2568 = global_1.member.member_5.member_2.member_1;
let _e2575 = global_1.member.member_5.member.member_2;
let _e2581 = global_1.member.member_5.member_1.member_2;
let _e2588 = global_1.member.member_5.member_2.member_2;
phi_7234_ = type_20(_e2127, vec3<f32>(((((_e2535 * _e2526) + (_e2541 * _e2528)) + (_e2548 * _e2530)) * _e2524), ((((_e2555 * _e2526) + (_e2561 * _e2528)) + (_e2568 * _e2530)) * _e2524), ((((_e2575 * _e2526) + (_e2581 * _e2528)) + (_e2588 * _e2530)) * _e2524)), _e2509.member, vec3<f32>(((((_e2535 * _e2509.member_2.x) + (_e2541 * _e2509.member_2.y)) + (_e2548 * _e2509.member_2.z)) * _e2524), ((((_e2555 * _e2509.member_2.x) + (_e2561 * _e2509.member_2.y)) + (_e2568 * _e2509.member_2.z)) * _e2524), ((((_e2575 * _e2509.member_2.x) + (_e2581 * _e2509.member_2.y)) + (_e2588 * _e2509.member_2.z)) * _e2524)), vec3<f32>(((((_e2535 * _e2509.member_1.x) + (_e2541 * _e2509.member_1.y)) + (_e2548 * _e2509.member_1.z)) * _e2524), ((((_e2555 * _e2509.member_1.x) + (_e2561 * _e2509.member_1.y)) + (_e2568 * _e2509.member_1.z)) * _e2524), ((((_e2575 * _e2509.member_1.x) + (_e2581 * _e2509.member_1.y)) + (_e2588 * _e2509.member_1.z)) * _e2524)));
} else {
let _e644 = select(-1f, _e468, (_e468 > -1f));
let _e646 = select(_e463, _e644, (_e644 < _e463));
let _e653 = select(0i, select(select(i32(_e646), i32(-2147483648), (_e646 < -2147483600f)), 2147483647i, (_e646 > 2147483500f)), (_e646 == _e646));
let _e657 = (_e653 - select(0i, 1i, (_e646 < f32(_e653))));
let _e659 = select(-1f, _e478, (_e478 > -1f));
let _e661 = select(_e473, _e659, (_e659 < _e473));
let _e668 = select(0i, select(select(i32(_e661), i32(-2147483648), (_e661 < -2147483600f)), 2147483647i, (_e661 > 2147483500f)), (_e661 == _e661));
let _e672 = (_e668 - select(0i, 1i, (_e661 < f32(_e668))));
let _e674 = select(-1f, _e488, (_e488 > -1f));
let _e676 = select(_e483, _e674, (_e674 < _e483));
let _e683 = select(0i, select(select(i32(_e676), i32(-2147483648), (_e676 < -2147483600f)), 2147483647i, (_e676 > 2147483500f)), (_e676 == _e676));
let _e687 = (_e683 - select(0i, 1i, (_e676 < f32(_e683))));
let _e692 = global_1.member.member_5.member_5[0u];
let _e697 = global_1.member.member_5.member_5[1u];
let _e705 = (select(0i, select(select(i32(_e473), i32(-2147483648), (_e473 < -2147483600f)), 2147483647i, (_e473 > 2147483500f)), (_e473 == _e473)) - 1i);
let _e708 = (_e672 + 1i);
let _e718 = (select(0i, select(select(i32(_e483), i32(-2147483648), (_e483 < -2147483600f)), 2147483647i, (_e483 > 2147483500f)), (_e483 == _e483)) - 1i);
let _e721 = (_e687 + 1i);
let _e730 = select(0i, select(select(i32(_e463), i32(-2147483648), (_e463 < -2147483600f)), 2147483647i, (_e463 > 2147483500f)), (_e463 == _e463));
let _e731 = (_e730 - 1i);
let _e732 = (_e657 - 1i);
let _e734 = select(0i, _e732, (_e732 > 0i));
let _e736 = select(0i, _e657, (_e657 > 0i));
let _e737 = (_e657 + 1i);
let _e739 = select(_e731, _e737, (_e737 < _e731));
let _e740 = (_e657 + 2i);
let _e743 = (_e730 - 2i);
let _e745 = select(0i, _e743, (_e743 > 0i));
let _e747 = select(_e745, _e734, (_e734 < _e745));
let _e749 = select(_e745, _e736, (_e736 < _e745));
let _e751 = select(_e745, _e739, (_e739 < _e745));
let _e770 = (select(0i, _e672, (_e672 > 0i)) * _e692);
let _e771 = (select(_e705, _e708, (_e708 < _e705)) * _e692);
let _e772 = (select(0i, _e687, (_e687 > 0i)) * _e697);
let _e773 = (select(_e718, _e721, (_e721 < _e718)) * _e697);
local_2 = type_18(array<i32, 4>(_e747, _e749, _e751, 0i), array<u32, 6>(bitcast<u32>(((_e734 - _e747) * 16i)), bitcast<u32>(((_e736 - _e747) * 16i)), bitcast<u32>(((_e736 - _e749) * 16i)), bitcast<u32>(((_e739 - _e749) * 16i)), bitcast<u32>(((_e739 - _e751) * 16i)), bitcast<u32>(((select(_e731, _e740, (_e740 < _e731)) - _e751) * 16i))));
local_3 = vec3<f32>((_e468 - f32(_e657)), (_e478 - f32(_e672)), (_e488 - f32(_e687)));
let _e788 = local_2.member[1u];
let _e789 = ((_e772 + _e770) + _e788);
let _e791 = (_e789 >> bitcast<u32>(1i));
let _e794 = bitcast<u32>(((_e789 & 1i) * 16i));
let _e796 = (bitcast<i32>(_e90) - 1i);
let _e798 = select(_e796, _e791, (_e791 < _e796));
let _e803 = global_2.member[bitcast<u32>(select(0i, _e798, (_e798 > 0i)))];
let _e807 = (_e791 + 1i);
let _e809 = select(_e796, _e807, (_e807 < _e796));
let _e814 = global_2.member[bitcast<u32>(select(0i, _e809, (_e809 > 0i)))];
let _e821 = ((_e803 >> bitcast<u32>((_e794 & 31u))) | ((_e814 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e794) & 31u))));
let _e824 = local_2.member_1[2u];
let _e830 = f32(bitcast<i32>(((_e821 >> bitcast<u32>((_e824 & 31u))) & 65535u)));
let _e833 = local_2.member_1[3u];
let _e840 = local_3[0u];
let _e843 = (_e830 + ((f32(bitcast<i32>(((_e821 >> bitcast<u32>((_e833 & 31u))) & 65535u))) - _e830) * _e840));
let _e845 = local_2.member[1u];
let _e846 = ((_e772 + _e771) + _e845);
let _e848 = (_e846 >> bitcast<u32>(1i));
let _e851 = bitcast<u32>(((_e846 & 1i) * 16i));
let _e853 = select(_e796, _e848, (_e848 < _e796));
let _e858 = global_2.member[bitcast<u32>(select(0i, _e853, (_e853 > 0i)))];
let _e862 = (_e848 + 1i);
let _e864 = select(_e796, _e862, (_e862 < _e796));
let _e869 = global_2.member[bitcast<u32>(select(0i, _e864, (_e864 > 0i)))];
let _e876 = ((_e858 >> bitcast<u32>((_e851 & 31u))) | ((_e869 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e851) & 31u))));
let _e877 = local_2.member_1[2u];
let _e883 = f32(bitcast<i32>(((_e876 >> bitcast<u32>((_e877 & 31u))) & 65535u)));
let _e884 = local_2.member_1[3u];
let _e891 = local_3[0u];
let _e896 = local_3[1u];
let _e899 = (_e843 + (((_e883 + ((f32(bitcast<i32>(((_e876 >> bitcast<u32>((_e884 & 31u))) & 65535u))) - _e883) * _e891)) - _e843) * _e896));
let _e901 = local_2.member[1u];
let _e902 = ((_e773 + _e770) + _e901);
let _e904 = (_e902 >> bitcast<u32>(1i));
let _e907 = bitcast<u32>(((_e902 & 1i) * 16i));
let _e909 = select(_e796, _e904, (_e904 < _e796));
let _e914 = global_2.member[bitcast<u32>(select(0i, _e909, (_e909 > 0i)))];
let _e918 = (_e904 + 1i);
let _e920 = select(_e796, _e918, (_e918 < _e796));
let _e925 = global_2.member[bitcast<u32>(select(0i, _e920, (_e920 > 0i)))];
let _e932 = ((_e914 >> bitcast<u32>((_e907 & 31u))) | ((_e925 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e907) & 31u))));
let _e933 = local_2.member_1[2u];
let _e939 = f32(bitcast<i32>(((_e932 >> bitcast<u32>((_e933 & 31u))) & 65535u)));
let _e940 = local_2.member_1[3u];
let _e947 = local_3[0u];
let _e950 = (_e939 + ((f32(bitcast<i32>(((_e932 >> bitcast<u32>((_e940 & 31u))) & 65535u))) - _e939) * _e947));
let _e952 = local_2.member[1u];
let _e953 = ((_e773 + _e771) + _e952);
let _e955 = (_e953 >> bitcast<u32>(1i));
let _e958 = bitcast<u32>(((_e953 & 1i) * 16i));
let _e960 = select(_e796, _e955, (_e955 < _e796));
let _e965 = global_2.member[bitcast<u32>(select(0i, _e960, (_e960 > 0i)))];
let _e969 = (_e955 + 1i);
let _e971 = select(_e796, _e969, (_e969 < _e796));
let _e976 = global_2.member[bitcast<u32>(select(0i, _e971, (_e971 > 0i)))];
let _e983 = ((_e965 >> bitcast<u32>((_e958 & 31u))) | ((_e976 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e958) & 31u))));
let _e984 = local_2.member_1[2u];
let _e990 = f32(bitcast<i32>(((_e983 >> bitcast<u32>((_e984 & 31u))) & 65535u)));
let _e991 = local_2.member_1[3u];
let _e998 = local_3[0u];
let _e1002 = local_3[1u];
let _e1007 = local_3[2u];
let _e1015 = global_1.member.member_5.member_4.member;
let _e1021 = global_1.member.member_5.member_4.member_1;
let _e1022 = (((_e899 + (((_e950 + (((_e990 + ((f32(bitcast<i32>(((_e983 >> bitcast<u32>((_e991 & 31u))) & 65535u))) - _e990) * _e998)) - _e950) * _e1002)) - _e899) * _e1007)) * _e1015) + _e1021);
let _e1024 = select(0f, _e1022, (_e1022 > 0f));
phi_7234_ = type_20(select(1f, _e1024, (_e1024 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2641 = phi_7234_;
let _e2643 = select(-0.5f, _e399, (_e399 > -0.5f));
let _e2645 = select(_e464, _e2643, (_e2643 < _e464));
let _e2647 = select(-0.5f, _e417, (_e417 > -0.5f));
let _e2649 = select(_e474, _e2647, (_e2647 < _e474));
let _e2651 = select(-0.5f, _e435, (_e435 > -0.5f));
let _e2653 = select(_e484, _e2651, (_e2651 < _e484));
let _e2655 = select(-1f, _e2645, (_e2645 > -1f));
let _e2657 = select(_e463, _e2655, (_e2655 < _e463));
let _e2664 = select(0i, select(select(i32(_e2657), i32(-2147483648), (_e2657 < -2147483600f)), 2147483647i, (_e2657 > 2147483500f)), (_e2657 == _e2657));
let _e2668 = (_e2664 - select(0i, 1i, (_e2657 < f32(_e2664))));
let _e2670 = select(-1f, _e2649, (_e2649 > -1f));
let _e2672 = select(_e473, _e2670, (_e2670 < _e473));
let _e2679 = select(0i, select(select(i32(_e2672), i32(-2147483648), (_e2672 < -2147483600f)), 2147483647i, (_e2672 > 2147483500f)), (_e2672 == _e2672));
let _e2683 = (_e2679 - select(0i, 1i, (_e2672 < f32(_e2679))));
let _e2685 = select(-1f, _e2653, (_e2653 > -1f));
let _e2687 = select(_e483, _e2685, (_e2685 < _e483));
let _e2694 = select(0i, select(select(i32(_e2687), i32(-2147483648), (_e2687 < -2147483600f)), 2147483647i, (_e2687 > 2147483500f)), (_e2687 == _e2687));
let _e2698 = (_e2694 - select(0i, 1i, (_e2687 < f32(_e2694))));
let _e2703 = global_1.member.member_5.member_5[0u];
let _e2708 = global_1.member.member_5.member_5[1u];
let _e2716 = (select(0i, select(select(i32(_e473), i32(-2147483648), (_e473 < -2147483600f)), 2147483647i, (_e473 > 2147483500f)), (_e473 == _e473)) - 1i);
let _e2719 = (_e2683 + 1i);
let _e2729 = (select(0i, select(select(i32(_e483), i32(-2147483648), (_e483 < -2147483600f)), 2147483647i, (_e483 > 2147483500f)), (_e483 == _e483)) - 1i);
let _e2732 = (_e2698 + 1i);
let _e2741 = select(0i, select(select(i32(_e463), i32(-2147483648), (_e463 < -2147483600f)), 2147483647i, (_e463 > 2147483500f)), (_e463 == _e463));
let _e2742 = (_e2741 - 1i);
let _e2743 = (_e2668 - 1i);
let _e2745 = select(0i, _e2743, (_e2743 > 0i));
let _e2747 = select(0i, _e2668, (_e2668 > 0i));
let _e2748 = (_e2668 + 1i);
let _e2750 = select(_e2742, _e2748, (_e2748 < _e2742));
let _e2751 = (_e2668 + 2i);
let _e2754 = (_e2741 - 2i);
let _e2756 = select(0i, _e2754, (_e2754 > 0i));
let _e2758 = select(_e2756, _e2745, (_e2745 < _e2756));
let _e2760 = select(_e2756, _e2747, (_e2747 < _e2756));
let _e2762 = select(_e2756, _e2750, (_e2750 < _e2756));
let _e2781 = (select(0i, _e2683, (_e2683 > 0i)) * _e2703);
let _e2782 = (select(_e2716, _e2719, (_e2719 < _e2716)) * _e2703);
let _e2783 = (select(0i, _e2698, (_e2698 > 0i)) * _e2708);
let _e2784 = (select(_e2729, _e2732, (_e2732 < _e2729)) * _e2708);
local = type_18(array<i32, 4>(_e2758, _e2760, _e2762, 0i), array<u32, 6>(bitcast<u32>(((_e2745 - _e2758) * 16i)), bitcast<u32>(((_e2747 - _e2758) * 16i)), bitcast<u32>(((_e2747 - _e2760) * 16i)), bitcast<u32>(((_e2750 - _e2760) * 16i)), bitcast<u32>(((_e2750 - _e2762) * 16i)), bitcast<u32>(((select(_e2742, _e2751, (_e2751 < _e2742)) - _e2762) * 16i))));
local_1 = vec3<f32>((_e2645 - f32(_e2668)), (_e2649 - f32(_e2683)), (_e2653 - f32(_e2698)));
let _e2799 = local.member[1u];
let _e2800 = ((_e2783 + _e2781) + _e2799);
let _e2802 = (_e2800 >> bitcast<u32>(1i));
let _e2805 = bitcast<u32>(((_e2800 & 1i) * 16i));
let _e2807 = (bitcast<i32>(_e90) - 1i);
let _e2809 = select(_e2807, _e2802, (_e2802 < _e2807));
let _e2814 = global_2.member[bitcast<u32>(select(0i, _e2809, (_e2809 > 0i)))];
let _e2818 = (_e2802 + 1i);
let _e2820 = select(_e2807, _e2818, (_e2818 < _e2807));
let _e2825 = global_2.member[bitcast<u32>(select(0i, _e2820, (_e2820 > 0i)))];
let _e2832 = ((_e2814 >> bitcast<u32>((_e2805 & 31u))) | ((_e2825 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2805) & 31u))));
let _e2835 = local.member_1[2u];
let _e2841 = f32(bitcast<i32>(((_e2832 >> bitcast<u32>((_e2835 & 31u))) & 65535u)));
let _e2844 = local.member_1[3u];
let _e2851 = local_1[0u];
let _e2854 = (_e2841 + ((f32(bitcast<i32>(((_e2832 >> bitcast<u32>((_e2844 & 31u))) & 65535u))) - _e2841) * _e2851));
let _e2856 = local.member[1u];
let _e2857 = ((_e2783 + _e2782) + _e2856);
let _e2859 = (_e2857 >> bitcast<u32>(1i));
let _e2862 = bitcast<u32>(((_e2857 & 1i) * 16i));
let _e2864 = select(_e2807, _e2859, (_e2859 < _e2807));
let _e2869 = global_2.member[bitcast<u32>(select(0i, _e2864, (_e2864 > 0i)))];
let _e2873 = (_e2859 + 1i);
let _e2875 = select(_e2807, _e2873, (_e2873 < _e2807));
let _e2880 = global_2.member[bitcast<u32>(select(0i, _e2875, (_e2875 > 0i)))];
let _e2887 = ((_e2869 >> bitcast<u32>((_e2862 & 31u))) | ((_e2880 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2862) & 31u))));
let _e2888 = local.member_1[2u];
let _e2894 = f32(bitcast<i32>(((_e2887 >> bitcast<u32>((_e2888 & 31u))) & 65535u)));
let _e2895 = local.member_1[3u];
let _e2902 = local_1[0u];
let _e2907 = local_1[1u];
let _e2910 = (_e2854 + (((_e2894 + ((f32(bitcast<i32>(((_e2887 >> bitcast<u32>((_e2895 & 31u))) & 65535u))) - _e2894) * _e2902)) - _e2854) * _e2907));
let _e2912 = local.member[1u];
let _e2913 = ((_e2784 + _e2781) + _e2912);
let _e2915 = (_e2913 >> bitcast<u32>(1i));
let _e2918 = bitcast<u32>(((_e2913 & 1i) * 16i));
let _e2920 = select(_e2807, _e2915, (_e2915 < _e2807));
let _e2925 = global_2.member[bitcast<u32>(select(0i, _e2920, (_e2920 > 0i)))];
let _e2929 = (_e2915 + 1i);
let _e2931 = select(_e2807, _e2929, (_e2929 < _e2807));
let _e2936 = global_2.member[bitcast<u32>(select(0i, _e2931, (_e2931 > 0i)))];
let _e2943 = ((_e2925 >> bitcast<u32>((_e2918 & 31u))) | ((_e2936 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2918) & 31u))));
let _e2944 = local.member_1[2u];
let _e2950 = f32(bitcast<i32>(((_e2943 >> bitcast<u32>((_e2944 & 31u))) & 65535u)));
let _e2951 = local.member_1[3u];
let _e2958 = local_1[0u];
let _e2961 = (_e2950 + ((f32(bitcast<i32>(((_e2943 >> bitcast<u32>((_e2951 & 31u))) & 65535u))) - _e2950) * _e2958));
let _e2963 = local.member[1u];
let _e2964 = ((_e2784 + _e2782) + _e2963);
let _e2966 = (_e2964 >> bitcast<u32>(1i));
let _e2969 = bitcast<u32>(((_e2964 & 1i) * 16i));
let _e2971 = select(_e2807, _e2966, (_e2966 < _e2807));
let _e2976 = global_2.member[bitcast<u32>(select(0i, _e2971, (_e2971 > 0i)))];
let _e2980 = (_e2966 + 1i);
let _e2982 = select(_e2807, _e2980, (_e2980 < _e2807));
let _e2987 = global_2.member[bitcast<u32>(select(0i, _e2982, (_e2982 > 0i)))];
let _e2994 = ((_e2976 >> bitcast<u32>((_e2969 & 31u))) | ((_e2987 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2969) & 31u))));
let _e2995 = local.member_1[2u];
let _e3001 = f32(bitcast<i32>(((_e2994 >> bitcast<u32>((_e2995 & 31u))) & 65535u)));
let _e3002 = local.member_1[3u];
let _e3009 = local_1[0u];
let _e3013 = local_1[1u];
let _e3018 = local_1[2u];
let _e3026 = global_1.member.member_5.member_4.member;
let _e3032 = global_1.member.member_5.member_4.member_1;
let _e3033 = (((_e2910 + (((_e2961 + (((_e3001 + ((f32(bitcast<i32>(((_e2994 >> bitcast<u32>((_e3002 & 31u))) & 65535u))) - _e3001) * _e3009)) - _e2961) * _e3013)) - _e2910) * _e3018)) * _e3026) + _e3032);
let _e3035 = select(0f, _e3033, (_e3033 > 0f));
if ((_e622 & 16u) == 0u) {
phi_8795_ = type_21(1f, 1f, 1f);
} else {
let _e3042 = global_1.member.member_18;
let _e3046 = global_1.member.member_22.member;
let _e3056 = ((((_e3042.member * _e307) + (_e3042.member_1 * _e316)) + (_e3042.member_2 * _e289)) + _e3042.member_3);
let _e3062 = ((((_e3042.member * _e328) + (_e3042.member_1 * _e333)) + (_e3042.member_2 * _e322)) + _e3042.member_3);
let _e3064 = select(_e3062, _e3056, (_e3056 < _e3062));
let _e3066 = select(_e3062, _e3056, (_e3056 > _e3062));
let _e3068 = (_e3066 - _e3064);
let _e3071 = (-(_e3064) / select(1e-30f, _e3068, (_e3068 > 1e-30f)));
let _e3073 = select(0f, _e3071, (_e3071 > 0f));
let _e3079 = select(select(select(1f, _e3073, (_e3073 < 1f)), 1f, (_e3066 <= 0f)), 0f, (_e3064 > 0f));
let _e3081 = (_e3046 > 0.5f);
let _e3090 = global_1.member.member_19;
let _e3094 = global_1.member.member_22.member_1;
let _e3104 = ((((_e3090.member * _e307) + (_e3090.member_1 * _e316)) + (_e3090.member_2 * _e289)) + _e3090.member_3);
let _e3110 = ((((_e3090.member * _e328) + (_e3090.member_1 * _e333)) + (_e3090.member_2 * _e322)) + _e3090.member_3);
let _e3112 = select(_e3110, _e3104, (_e3104 < _e3110));
let _e3114 = select(_e3110, _e3104, (_e3104 > _e3110));
let _e3116 = (_e3114 - _e3112);
let _e3119 = (-(_e3112) / select(1e-30f, _e3116, (_e3116 > 1e-30f)));
let _e3121 = select(0f, _e3119, (_e3119 > 0f));
let _e3127 = select(select(select(1f, _e3121, (_e3121 < 1f)), 1f, (_e3114 <= 0f)), 0f, (_e3112 > 0f));
let _e3129 = (_e3094 > 0.5f);
let _e3138 = global_1.member.member_20;
let _e3142 = global_1.member.member_22.member_2;
let _e3152 = ((((_e3138.member * _e307) + (_e3138.member_1 * _e316)) + (_e3138.member_2 * _e289)) + _e3138.member_3);
let _e3158 = ((((_e3138.member * _e328) + (_e3138.member_1 * _e333)) + (_e3138.member_2 * _e322)) + _e3138.member_3);
let _e3160 = select(_e3158, _e3152, (_e3152 < _e3158));
let _e3162 = select(_e3158, _e3152, (_e3152 > _e3158));
let _e3164 = (_e3162 - _e3160);
let _e3167 = (-(_e3160) / select(1e-30f, _e3164, (_e3164 > 1e-30f)));
let _e3169 = select(0f, _e3167, (_e3167 > 0f));
let _e3175 = select(select(select(1f, _e3169, (_e3169 < 1f)), 1f, (_e3162 <= 0f)), 0f, (_e3160 > 0f));
let _e3177 = (_e3142 > 0.5f);
let _e3186 = global_1.member.member_21;
let _e3190 = global_1.member.member_22.member_3;
let _e3200 = ((((_e3186.member * _e307) + (_e3186.member_1 * _e316)) + (_e3186.member_2 * _e289)) + _e3186.member_3);
let _e3206 = ((((_e3186.member * _e328) + (_e3186.member_1 * _e333)) + (_e3186.member_2 * _e322)) + _e3186.member_3);
let _e3208 = select(_e3206, _e3200, (_e3200 < _e3206));
let _e3210 = select(_e3206, _e3200, (_e3200 > _e3206));
let _e3212 = (_e3210 - _e3208);
let _e3215 = (-(_e3208) / select(1e-30f, _e3212, (_e3212 > 1e-30f)));
let _e3217 = select(0f, _e3215, (_e3215 > 0f));
let _e3223 = select(select(select(1f, _e3217, (_e3217 < 1f)), 1f, (_e3210 <= 0f)), 0f, (_e3208 > 0f));
let _e3225 = (_e3190 > 0.5f);
phi_8795_ = type_21(((((1f * _e3079) * _e3127) * _e3175) * _e3223), ((((1f * select(1f, _e3079, _e3081)) * select(1f, _e3127, _e3129)) * select(1f, _e3175, _e3177)) * select(1f, _e3223, _e3225)), ((((1f * select(1f, 0f, (_e3081 && (_e3062 > 0f)))) * select(1f, 0f, (_e3129 && (_e3110 > 0f)))) * select(1f, 0f, (_e3177 && (_e3158 > 0f)))) * select(1f, 0f, (_e3225 && (_e3206 > 0f)))));
}
let _e3234 = phi_8795_;
let _e3235 = (_e328 - _e307);
let _e3236 = (_e333 - _e316);
let _e3237 = (_e322 - _e289);
let _e3242 = (((_e3235 * _e3235) + (_e3236 * _e3236)) + (_e3237 * _e3237));
let _e3246 = (_e494 < 1e-12f);
let _e3248 = (1f / select(_e489, 1f, _e3246));
let _e3250 = ((-0.5f - _e399) * _e3248);
let _e3252 = ((_e464 - _e399) * _e3248);
let _e3258 = select(_e3252, _e3250, (_e3250 < _e3252));
let _e3260 = select(0f, _e3258, (_e3258 > 0f));
let _e3263 = select(select(1f, _e3260, (_e3260 < 1f)), select(2f, 0f, ((_e399 >= -0.5f) && (_e399 <= _e464))), _e3246);
let _e3265 = select(_e3252, _e3250, (_e3250 > _e3252));
let _e3267 = select(0f, _e3265, (_e3265 > 0f));
let _e3270 = select(select(1f, _e3267, (_e3267 < 1f)), 1f, _e3246);
let _e3271 = (_e497 < 1e-12f);
let _e3273 = (1f / select(_e490, 1f, _e3271));
let _e3275 = ((-0.5f - _e417) * _e3273);
let _e3277 = ((_e474 - _e417) * _e3273);
let _e3283 = select(_e3277, _e3275, (_e3275 < _e3277));
let _e3285 = select(0f, _e3283, (_e3283 > 0f));
let _e3288 = select(select(1f, _e3285, (_e3285 < 1f)), select(2f, 0f, ((_e417 >= -0.5f) && (_e417 <= _e474))), _e3271);
let _e3290 = select(_e3277, _e3275, (_e3275 > _e3277));
let _e3292 = select(0f, _e3290, (_e3290 > 0f));
let _e3295 = select(select(1f, _e3292, (_e3292 < 1f)), 1f, _e3271);
let _e3296 = (_e502 < 1e-12f);
let _e3298 = (1f / select(_e491, 1f, _e3296));
let _e3300 = ((-0.5f - _e435) * _e3298);
let _e3302 = ((_e484 - _e435) * _e3298);
let _e3308 = select(_e3302, _e3300, (_e3300 < _e3302));
let _e3310 = select(0f, _e3308, (_e3308 > 0f));
let _e3313 = select(select(1f, _e3310, (_e3310 < 1f)), select(2f, 0f, ((_e435 >= -0.5f) && (_e435 <= _e484))), _e3296);
let _e3315 = select(_e3302, _e3300, (_e3300 > _e3302));
let _e3317 = select(0f, _e3315, (_e3315 > 0f));
let _e3320 = select(select(1f, _e3317, (_e3317 < 1f)), 1f, _e3296);
let _e3322 = select(_e3295, _e3270, (_e3270 < _e3295));
let _e3326 = select(_e3288, _e3263, (_e3263 > _e3288));
let _e3329 = (select(_e3320, _e3322, (_e3322 < _e3320)) - select(_e3313, _e3326, (_e3326 > _e3313)));
let _e3336 = global_1.member.member_4.member_3;
let _e3337 = ((sqrt(select(0f, _e3242, (_e3242 > 0f))) * select(0f, _e3329, (_e3329 > 0f))) * _e3336);
let _e3339 = (select(1f, _e3035, (_e3035 < 1f)) * 255f);
let _e3340 = (_e2641.member * 255f);
let _e3341 = (255f - 1f);
let _e3343 = select(0f, _e3339, (_e3339 > 0f));
let _e3345 = select(_e3341, _e3343, (_e3343 < _e3341));
let _e3352 = select(0i, select(select(i32(_e3345), i32(-2147483648), (_e3345 < -2147483600f)), 2147483647i, (_e3345 > 2147483500f)), (_e3345 == _e3345));
let _e3356 = (_e3352 - select(0i, 1i, (_e3345 < f32(_e3352))));
let _e3358 = select(0f, _e3340, (_e3340 > 0f));
let _e3360 = select(_e3341, _e3358, (_e3358 < _e3341));
let _e3367 = select(0i, select(select(i32(_e3360), i32(-2147483648), (_e3360 < -2147483600f)), 2147483647i, (_e3360 > 2147483500f)), (_e3360 == _e3360));
let _e3371 = (_e3367 - select(0i, 1i, (_e3360 < f32(_e3367))));
let _e3374 = (((_e3356 * 256i) + _e3371) * 4i);
let _e3376 = (_e3339 - f32(_e3356));
let _e3378 = (_e3340 - f32(_e3371));
let _e3380 = (bitcast<i32>(_e94) - 1i);
let _e3382 = select(_e3380, _e3374, (_e3374 < _e3380));
let _e3388 = global_4.member[bitcast<u32>(select(0i, _e3382, (_e3382 > 0i)))];
let _e3389 = (_e3374 + 4i);
let _e3391 = select(_e3380, _e3389, (_e3389 < _e3380));
let _e3397 = global_4.member[bitcast<u32>(select(0i, _e3391, (_e3391 > 0i)))];
let _e3398 = (_e3374 + 1024i);
let _e3400 = select(_e3380, _e3398, (_e3398 < _e3380));
let _e3406 = global_4.member[bitcast<u32>(select(0i, _e3400, (_e3400 > 0i)))];
let _e3407 = (_e3374 + 1028i);
let _e3409 = select(_e3380, _e3407, (_e3407 < _e3380));
let _e3415 = global_4.member[bitcast<u32>(select(0i, _e3409, (_e3409 > 0i)))];
let _e3420 = (bitcast<f32>(((_e3388 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3428 = (_e3420 + (((bitcast<f32>(((_e3397 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3420) * _e3378));
let _e3433 = (bitcast<f32>(((_e3406 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3457 = (bitcast<f32>((((_e3388 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3465 = (_e3457 + (((bitcast<f32>((((_e3397 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3457) * _e3378));
let _e3470 = (bitcast<f32>((((_e3406 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3482 = (_e3374 + 1i);
let _e3484 = select(_e3380, _e3482, (_e3482 < _e3380));
let _e3490 = global_4.member[bitcast<u32>(select(0i, _e3484, (_e3484 > 0i)))];
let _e3491 = (_e3374 + 5i);
let _e3493 = select(_e3380, _e3491, (_e3491 < _e3380));
let _e3499 = global_4.member[bitcast<u32>(select(0i, _e3493, (_e3493 > 0i)))];
let _e3500 = (_e3374 + 1025i);
let _e3502 = select(_e3380, _e3500, (_e3500 < _e3380));
let _e3508 = global_4.member[bitcast<u32>(select(0i, _e3502, (_e3502 > 0i)))];
let _e3509 = (_e3374 + 1029i);
let _e3511 = select(_e3380, _e3509, (_e3509 < _e3380));
let _e3517 = global_4.member[bitcast<u32>(select(0i, _e3511, (_e3511 > 0i)))];
let _e3522 = (bitcast<f32>(((_e3490 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3530 = (_e3522 + (((bitcast<f32>(((_e3499 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3522) * _e3378));
let _e3535 = (bitcast<f32>(((_e3508 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3559 = (bitcast<f32>((((_e3490 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3567 = (_e3559 + (((bitcast<f32>((((_e3499 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3559) * _e3378));
let _e3572 = (bitcast<f32>((((_e3508 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3587 = (_e3337 * _e3234.member_1);
let _e3589 = -(((_e3465 + (((_e3470 + (((bitcast<f32>((((_e3415 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3470) * _e3378)) - _e3465) * _e3376)) * _e3587));
let _e3591 = select(-87f, _e3589, (_e3589 > -87f));
let _e3593 = select(88f, _e3591, (_e3591 < 88f));
let _e3595 = ((_e3593 * 1.442695f) + 0.5f);
let _e3597 = select(-127f, _e3595, (_e3595 > -127f));
let _e3599 = select(128f, _e3597, (_e3597 < 128f));
let _e3606 = select(0i, select(select(i32(_e3599), i32(-2147483648), (_e3599 < -2147483600f)), 2147483647i, (_e3599 > 2147483500f)), (_e3599 == _e3599));
let _e3610 = (_e3606 - select(0i, 1i, (_e3599 < f32(_e3606))));
let _e3611 = f32(_e3610);
let _e3615 = ((_e3593 - (_e3611 * 0.6933594f)) - (_e3611 * -2.1219444e-4f));
let _e3637 = -(((_e3530 + (((_e3535 + (((bitcast<f32>(((_e3517 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3535) * _e3378)) - _e3530) * _e3376)) * _e3587));
let _e3639 = select(-87f, _e3637, (_e3637 > -87f));
let _e3641 = select(88f, _e3639, (_e3639 < 88f));
let _e3643 = ((_e3641 * 1.442695f) + 0.5f);
let _e3645 = select(-127f, _e3643, (_e3643 > -127f));
let _e3647 = select(128f, _e3645, (_e3645 < 128f));
let _e3654 = select(0i, select(select(i32(_e3647), i32(-2147483648), (_e3647 < -2147483600f)), 2147483647i, (_e3647 > 2147483500f)), (_e3647 == _e3647));
let _e3658 = (_e3654 - select(0i, 1i, (_e3647 < f32(_e3654))));
let _e3659 = f32(_e3658);
let _e3663 = ((_e3641 - (_e3659 * 0.6933594f)) - (_e3659 * -2.1219444e-4f));
let _e3685 = -(((_e3567 + (((_e3572 + (((bitcast<f32>((((_e3517 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3572) * _e3378)) - _e3567) * _e3376)) * _e3587));
let _e3687 = select(-87f, _e3685, (_e3685 > -87f));
let _e3689 = select(88f, _e3687, (_e3687 < 88f));
let _e3691 = ((_e3689 * 1.442695f) + 0.5f);
let _e3693 = select(-127f, _e3691, (_e3691 > -127f));
let _e3695 = select(128f, _e3693, (_e3693 < 128f));
let _e3702 = select(0i, select(select(i32(_e3695), i32(-2147483648), (_e3695 < -2147483600f)), 2147483647i, (_e3695 > 2147483500f)), (_e3695 == _e3695));
let _e3706 = (_e3702 - select(0i, 1i, (_e3695 < f32(_e3702))));
let _e3707 = f32(_e3706);
let _e3711 = ((_e3689 - (_e3707 * 0.6933594f)) - (_e3707 * -2.1219444e-4f));
let _e3733 = -(((_e3428 + (((_e3433 + (((bitcast<f32>(((_e3415 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3433) * _e3378)) - _e3428) * _e3376)) * (_e3337 * _e3234.member)));
let _e3735 = select(-87f, _e3733, (_e3733 > -87f));
let _e3737 = select(88f, _e3735, (_e3735 < 88f));
let _e3739 = ((_e3737 * 1.442695f) + 0.5f);
let _e3741 = select(-127f, _e3739, (_e3739 > -127f));
let _e3743 = select(128f, _e3741, (_e3741 < 128f));
let _e3750 = select(0i, select(select(i32(_e3743), i32(-2147483648), (_e3743 < -2147483600f)), 2147483647i, (_e3743 > 2147483500f)), (_e3743 == _e3743));
let _e3754 = (_e3750 - select(0i, 1i, (_e3743 < f32(_e3750))));
let _e3755 = f32(_e3754);
let _e3759 = ((_e3737 - (_e3755 * 0.6933594f)) - (_e3755 * -2.1219444e-4f));
let _e3779 = ((1f + (_e3759 * (1f + (_e3759 * (0.5f + (_e3759 * (0.16666667f + (_e3759 * (0.041666668f + (_e3759 * (0.008333334f + (_e3759 * (0.001388889f + (_e3759 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3754 + 127i)) << bitcast<u32>(23i))));
if _e642 {
let _e3794 = global_1.member.member_24.member_2;
let _e3797 = (_e2641.member_3.x * _e3234.member_2);
let _e3799 = (_e2641.member_3.y * _e3234.member_2);
let _e3801 = (_e2641.member_3.z * _e3234.member_2);
let _e3802 = (0.5f * (_e246 / _e198));
let _e3806 = (_e176 + (_e3797 * _e3802));
let _e3807 = (_e187 + (_e3799 * _e3802));
let _e3808 = (_e198 + (_e3801 * _e3802));
let _e3810 = (2f * _e246);
let _e3812 = ((_e3808 * _e3808) + (_e3810 * _e3801));
let _e3816 = (_e3808 + sqrt(select(0f, _e3812, (_e3812 > 0f))));
let _e3820 = (0.5f * (_e3810 / select(1e-6f, _e3816, (_e3816 > 1e-6f))));
let _e3824 = (_e3806 + (_e3797 * _e3820));
let _e3825 = (_e3807 + (_e3799 * _e3820));
let _e3826 = (_e3808 + (_e3801 * _e3820));
let _e3830 = (_e3794 * _e3794);
let _e3832 = (_e3826 * _e3826);
let _e3840 = (((_e3808 <= 0f) || (_e3812 <= 0f)) || ((_e3826 <= 0f) || (_e3832 <= (_e3830 * (((_e3824 * _e3824) + (_e3825 * _e3825)) + _e3832)))));
let _e3854 = (_e176 + ((_e2641.member_4.x * _e3234.member_2) * _e246));
let _e3855 = (_e187 + ((_e2641.member_4.y * _e3234.member_2) * _e246));
let _e3856 = (_e198 + ((_e2641.member_4.z * _e3234.member_2) * _e246));
let _e3858 = (_e3856 * _e3856);
let _e3867 = ((_e622 & 1u) != 0u);
phi_9819_ = select(select(select(_e3826, _e3808, _e3840), _e3856, _e3867), _e198, _e629);
phi_9820_ = select(select(select(_e3825, _e3807, _e3840), _e3855, _e3867), _e187, _e629);
phi_9821_ = select(select(select(_e3824, _e3806, _e3840), _e3854, _e3867), _e176, _e629);
phi_9822_ = (select(_e3840, ((_e3856 <= 0f) || (_e3858 <= (_e3830 * (((_e3854 * _e3854) + (_e3855 * _e3855)) + _e3858)))), _e3867) && !(_e629));
} else {
phi_9819_ = _e198;
phi_9820_ = _e187;
phi_9821_ = _e176;
phi_9822_ = false;
}
let _e3878 = phi_9819_;
let _e3880 = phi_9820_;
let _e3882 = phi_9821_;
let _e3884 = phi_9822_;
global_6.member[_e122] = (_e133 + _e261);
global_6.member[_e134] = (_e143 + _e268);
global_6.member[_e145] = (_e154 + _e370);
global_6.member[_e156] = (_e165 + _e373);
global_6.member[_e167] = _e3882;
global_6.member[_e178] = _e3880;
global_6.member[_e189] = _e3878;
global_6.member[_e200] = select((_e209 * (((1f + (_e3615 * (1f + (_e3615 * (0.5f + (_e3615 * (0.16666667f + (_e3615 * (0.041666668f + (_e3615 * (0.008333334f + (_e3615 * (0.001388889f + (_e3615 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3610 + 127i)) << bitcast<u32>(23i)))) * _e3779)), _e209, _e629);
global_6.member[_e211] = select((_e220 * (((1f + (_e3663 * (1f + (_e3663 * (0.5f + (_e3663 * (0.16666667f + (_e3663 * (0.041666668f + (_e3663 * (0.008333334f + (_e3663 * (0.001388889f + (_e3663 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3658 + 127i)) << bitcast<u32>(23i)))) * _e3779)), _e220, _e629);
global_6.member[_e222] = select((_e231 * (((1f + (_e3711 * (1f + (_e3711 * (0.5f + (_e3711 * (0.16666667f + (_e3711 * (0.041666668f + (_e3711 * (0.008333334f + (_e3711 * (0.001388889f + (_e3711 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3706 + 127i)) << bitcast<u32>(23i)))) * _e3779)), _e231, _e629);
global_6.member[_e233] = select(_e242, 1f, _e3884);
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
