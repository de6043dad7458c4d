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
var phi_5858_: type_19;
var phi_7202_: type_20;
var phi_8747_: type_21;
var phi_9771_: f32;
var phi_9772_: f32;
var phi_9773_: f32;
var phi_9774_: bool;
switch bitcast<i32>(0u) {
default: {
let _e89 = global;
let _e92 = arrayLength((&global_2.member));
let _e96 = arrayLength((&global_4.member));
let _e103 = global_1.member.member_1;
let _e106 = (_e89.x + _e103.x);
let _e109 = (_e89.y + _e103.y);
if (_e106 < _e103.z) {
if (_e109 < _e103.w) {
let _e117 = global_1.member.member[0u];
let _e121 = global_1.member.member[1u];
let _e122 = (_e117 * _e121);
let _e124 = ((_e109 * _e117) + _e106);
let _e125 = bitcast<i32>(_e124);
let _e127 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e129 = select(_e127, _e125, (_e125 < _e127));
let _e135 = global_6.member[bitcast<u32>(select(0i, _e129, (_e129 > 0i)))];
let _e136 = (_e122 + _e124);
let _e137 = bitcast<i32>(_e136);
let _e139 = select(_e127, _e137, (_e137 < _e127));
let _e145 = global_6.member[bitcast<u32>(select(0i, _e139, (_e139 > 0i)))];
let _e147 = ((2u * _e122) + _e124);
let _e148 = bitcast<i32>(_e147);
let _e150 = select(_e127, _e148, (_e148 < _e127));
let _e156 = global_6.member[bitcast<u32>(select(0i, _e150, (_e150 > 0i)))];
let _e158 = ((3u * _e122) + _e124);
let _e159 = bitcast<i32>(_e158);
let _e161 = select(_e127, _e159, (_e159 < _e127));
let _e167 = global_6.member[bitcast<u32>(select(0i, _e161, (_e161 > 0i)))];
let _e169 = ((4u * _e122) + _e124);
let _e170 = bitcast<i32>(_e169);
let _e172 = select(_e127, _e170, (_e170 < _e127));
let _e178 = global_6.member[bitcast<u32>(select(0i, _e172, (_e172 > 0i)))];
let _e180 = ((5u * _e122) + _e124);
let _e181 = bitcast<i32>(_e180);
let _e183 = select(_e127, _e181, (_e181 < _e127));
let _e189 = global_6.member[bitcast<u32>(select(0i, _e183, (_e183 > 0i)))];
let _e191 = ((6u * _e122) + _e124);
let _e192 = bitcast<i32>(_e191);
let _e194 = select(_e127, _e192, (_e192 < _e127));
let _e200 = global_6.member[bitcast<u32>(select(0i, _e194, (_e194 > 0i)))];
let _e202 = ((7u * _e122) + _e124);
let _e203 = bitcast<i32>(_e202);
let _e205 = select(_e127, _e203, (_e203 < _e127));
let _e211 = global_6.member[bitcast<u32>(select(0i, _e205, (_e205 > 0i)))];
let _e213 = ((8u * _e122) + _e124);
let _e214 = bitcast<i32>(_e213);
let _e216 = select(_e127, _e214, (_e214 < _e127));
let _e222 = global_6.member[bitcast<u32>(select(0i, _e216, (_e216 > 0i)))];
let _e224 = ((9u * _e122) + _e124);
let _e225 = bitcast<i32>(_e224);
let _e227 = select(_e127, _e225, (_e225 < _e127));
let _e233 = global_6.member[bitcast<u32>(select(0i, _e227, (_e227 > 0i)))];
let _e235 = ((10u * _e122) + _e124);
let _e236 = bitcast<i32>(_e235);
let _e238 = select(_e127, _e236, (_e236 < _e127));
let _e244 = global_6.member[bitcast<u32>(select(0i, _e238, (_e238 > 0i)))];
let _e248 = global_1.member.member_4.member_2;
let _e251 = (1f / select(1e-6f, _e200, (_e200 > 1e-6f)));
let _e255 = global_1.member.member_7.member_3;
let _e256 = (_e248 * _e255);
let _e261 = global_1.member.member_8.member;
let _e263 = (((_e178 * _e251) - _e261) * _e256);
let _e268 = global_1.member.member_8.member_1;
let _e270 = (((_e189 * _e251) - _e268) * _e256);
let _e274 = ((f32(bitcast<i32>(_e106)) - 0.5f) + _e135);
let _e278 = global_1.member.member_2[3u];
let _e279 = (_e278 + 1u);
let _e281 = select(1u, _e279, (_e279 > 0u));
let _e282 = (_e281 == 0u);
if _e282 {
break;
}
let _e287 = ((f32(bitcast<i32>((_e109 % _e281))) - 0.5f) + _e145);
let _e291 = global_1.member.member_4.member;
let _e295 = global_1.member.member_8.member_2;
let _e296 = (_e291 - _e295);
let _e300 = global_1.member.member_7.member;
let _e307 = global_1.member.member_7.member_2;
let _e309 = ((_e300 + (_e261 * _e296)) + ((_e274 + 0.5f) * _e307));
let _e313 = global_1.member.member_7.member_1;
let _e318 = ((_e313 + (_e268 * _e296)) + ((_e287 + 0.5f) * _e307));
let _e324 = global_1.member.member_4.member_1;
let _e325 = (_e324 - _e295);
let _e330 = ((_e300 + (_e261 * _e325)) + (((_e274 + _e263) + 0.5f) * _e307));
let _e335 = ((_e313 + (_e268 * _e325)) + (((_e287 + _e270) + 0.5f) * _e307));
if _e282 {
break;
}
let _e338 = bitcast<i32>(((_e109 / _e281) * 3u));
let _e340 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e342 = select(_e340, _e338, (_e338 < _e340));
let _e348 = global_5.member[bitcast<u32>(select(0i, _e342, (_e342 > 0i)))];
let _e349 = (_e338 + 1i);
let _e351 = select(_e340, _e349, (_e349 < _e340));
let _e357 = global_5.member[bitcast<u32>(select(0i, _e351, (_e351 > 0i)))];
let _e358 = (_e338 + 2i);
let _e360 = select(_e340, _e358, (_e358 < _e340));
let _e366 = global_5.member[bitcast<u32>(select(0i, _e360, (_e360 > 0i)))];
let _e369 = (1f / select(1e-6f, _e366, (_e366 > 1e-6f)));
let _e372 = (((_e348 * _e369) - _e261) * _e256);
let _e375 = (((_e357 * _e369) - _e268) * _e256);
let _e387 = global_1.member.member_5.member;
let _e400 = global_1.member.member_5.member.member_3;
let _e401 = ((((_e387.member * _e309) + (_e387.member_1 * _e318)) + (_e387.member_2 * _e291)) + _e400);
let _e405 = global_1.member.member_5.member_1;
let _e418 = global_1.member.member_5.member_1.member_3;
let _e419 = ((((_e405.member * _e309) + (_e405.member_1 * _e318)) + (_e405.member_2 * _e291)) + _e418);
let _e423 = global_1.member.member_5.member_2;
let _e436 = global_1.member.member_5.member_2.member_3;
let _e437 = ((((_e423.member * _e309) + (_e423.member_1 * _e318)) + (_e423.member_2 * _e291)) + _e436);
let _e443 = ((((_e387.member * _e330) + (_e387.member_1 * _e335)) + (_e387.member_2 * _e324)) + _e400);
let _e449 = ((((_e405.member * _e330) + (_e405.member_1 * _e335)) + (_e405.member_2 * _e324)) + _e418);
let _e455 = ((((_e423.member * _e330) + (_e423.member_1 * _e335)) + (_e423.member_2 * _e324)) + _e436);
let _e460 = global_1.member.member_5.member_3.member_3;
let _e465 = global_1.member.member_5.member_3.member;
let _e466 = (_e465 - 0.5f);
let _e468 = select(-0.5f, _e443, (_e443 > -0.5f));
let _e470 = select(_e466, _e468, (_e468 < _e466));
let _e475 = global_1.member.member_5.member_3.member_1;
let _e476 = (_e475 - 0.5f);
let _e478 = select(-0.5f, _e449, (_e449 > -0.5f));
let _e480 = select(_e476, _e478, (_e478 < _e476));
let _e485 = global_1.member.member_5.member_3.member_2;
let _e486 = (_e485 - 0.5f);
let _e488 = select(-0.5f, _e455, (_e455 > -0.5f));
let _e490 = select(_e486, _e488, (_e488 < _e486));
let _e491 = (_e443 - _e401);
let _e492 = (_e449 - _e419);
let _e493 = (_e455 - _e437);
let _e496 = bitcast<f32>((bitcast<u32>(_e491) & 2147483647u));
let _e499 = bitcast<f32>((bitcast<u32>(_e492) & 2147483647u));
let _e501 = select(_e499, _e496, (_e496 > _e499));
let _e504 = bitcast<f32>((bitcast<u32>(_e493) & 2147483647u));
let _e513 = bitcast<f32>((bitcast<u32>((_e443 - _e470)) & 2147483647u));
let _e516 = bitcast<f32>((bitcast<u32>((_e449 - _e480)) & 2147483647u));
let _e518 = select(_e516, _e513, (_e513 > _e516));
let _e521 = bitcast<f32>((bitcast<u32>((_e455 - _e490)) & 2147483647u));
let _e525 = (_e470 + 0.5f);
let _e526 = (_e465 - 1f);
let _e528 = select(0f, _e525, (_e525 > 0f));
let _e530 = select(_e526, _e528, (_e528 < _e526));
let _e537 = select(0i, select(select(i32(_e530), i32(-2147483648), (_e530 < -2147483600f)), 2147483647i, (_e530 > 2147483500f)), (_e530 == _e530));
let _e546 = global_1.member.member_5.member_7[3u];
let _e547 = (_e546 & 31i);
let _e550 = (_e480 + 0.5f);
let _e551 = (_e475 - 1f);
let _e553 = select(0f, _e550, (_e550 > 0f));
let _e555 = select(_e551, _e553, (_e553 < _e551));
let _e562 = select(0i, select(select(i32(_e555), i32(-2147483648), (_e555 < -2147483600f)), 2147483647i, (_e555 > 2147483500f)), (_e555 == _e555));
let _e569 = (_e490 + 0.5f);
let _e570 = (_e485 - 1f);
let _e572 = select(0f, _e569, (_e569 > 0f));
let _e574 = select(_e570, _e572, (_e572 < _e570));
let _e581 = select(0i, select(select(i32(_e574), i32(-2147483648), (_e574 < -2147483600f)), 2147483647i, (_e574 > 2147483500f)), (_e574 == _e574));
let _e592 = global_1.member.member_5.member_6[3u];
let _e598 = global_1.member.member_5.member_6[0u];
let _e603 = global_1.member.member_5.member_6[1u];
let _e607 = ((_e592 + ((_e537 - select(0i, 1i, (_e530 < f32(_e537)))) >> bitcast<u32>(_e547))) + (_e598 * (((_e562 - select(0i, 1i, (_e555 < f32(_e562)))) >> bitcast<u32>(_e547)) + (_e603 * ((_e581 - select(0i, 1i, (_e574 < f32(_e581)))) >> bitcast<u32>(_e547))))));
let _e609 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e611 = select(_e609, _e607, (_e607 < _e609));
let _e617 = global_3.member[bitcast<u32>(select(0i, _e611, (_e611 > 0i)))];
let _e624 = global_1.member.member[3u];
let _e631 = (((_e624 & 64u) != 0u) || ((((select(_e504, _e501, (_e501 > _e504)) <= _e460) && ((select(_e521, _e518, (_e518 > _e521)) > _e460) || (_e617 != 0u))) && true) && ((_e624 & 32u) != 0u)));
if (select(0u, select(7u, select(3u, 1u, ((((_e263 == 0f) && (_e270 == 0f)) && (_e372 == 0f)) && (_e375 == 0f))), _e631), (_e244 == 0f)) > 1u) {
let _e639 = global_1.member.member[2u];
if _e282 {
break;
}
if _e282 {
break;
}
let _e641 = (_e639 == 2u);
let _e644 = (((_e639 == 1u) || _e641) || (_e639 == 5u));
if _e644 {
let _e1021 = select(-1f, _e470, (_e470 > -1f));
let _e1023 = select(_e465, _e1021, (_e1021 < _e465));
let _e1030 = select(0i, select(select(i32(_e1023), i32(-2147483648), (_e1023 < -2147483600f)), 2147483647i, (_e1023 > 2147483500f)), (_e1023 == _e1023));
let _e1034 = (_e1030 - select(0i, 1i, (_e1023 < f32(_e1030))));
let _e1036 = select(-1f, _e480, (_e480 > -1f));
let _e1038 = select(_e475, _e1036, (_e1036 < _e475));
let _e1045 = select(0i, select(select(i32(_e1038), i32(-2147483648), (_e1038 < -2147483600f)), 2147483647i, (_e1038 > 2147483500f)), (_e1038 == _e1038));
let _e1049 = (_e1045 - select(0i, 1i, (_e1038 < f32(_e1045))));
let _e1051 = select(-1f, _e490, (_e490 > -1f));
let _e1053 = select(_e485, _e1051, (_e1051 < _e485));
let _e1060 = select(0i, select(select(i32(_e1053), i32(-2147483648), (_e1053 < -2147483600f)), 2147483647i, (_e1053 > 2147483500f)), (_e1053 == _e1053));
let _e1064 = (_e1060 - select(0i, 1i, (_e1053 < f32(_e1060))));
let _e1069 = global_1.member.member_5.member_5[0u];
let _e1074 = global_1.member.member_5.member_5[1u];
let _e1082 = (select(0i, select(select(i32(_e475), i32(-2147483648), (_e475 < -2147483600f)), 2147483647i, (_e475 > 2147483500f)), (_e475 == _e475)) - 1i);
let _e1083 = (_e1049 - 1i);
let _e1088 = (_e1049 + 1i);
let _e1091 = (_e1049 + 2i);
let _e1101 = (select(0i, select(select(i32(_e485), i32(-2147483648), (_e485 < -2147483600f)), 2147483647i, (_e485 > 2147483500f)), (_e485 == _e485)) - 1i);
let _e1102 = (_e1064 - 1i);
let _e1107 = (_e1064 + 1i);
let _e1110 = (_e1064 + 2i);
let _e1119 = select(0i, select(select(i32(_e465), i32(-2147483648), (_e465 < -2147483600f)), 2147483647i, (_e465 > 2147483500f)), (_e465 == _e465));
let _e1120 = (_e1119 - 1i);
let _e1121 = (_e1034 - 1i);
let _e1123 = select(0i, _e1121, (_e1121 > 0i));
let _e1126 = (_e1034 + 1i);
let _e1129 = (_e1034 + 2i);
let _e1132 = (_e1119 - 4i);
let _e1134 = select(0i, _e1132, (_e1132 > 0i));
let _e1136 = select(_e1134, _e1123, (_e1123 < _e1134));
let _e1149 = (select(0i, _e1083, (_e1083 > 0i)) * _e1069);
let _e1150 = (select(0i, _e1049, (_e1049 > 0i)) * _e1069);
let _e1151 = (select(_e1082, _e1088, (_e1088 < _e1082)) * _e1069);
let _e1152 = (select(_e1082, _e1091, (_e1091 < _e1082)) * _e1069);
let _e1153 = (select(0i, _e1102, (_e1102 > 0i)) * _e1074);
let _e1154 = (select(0i, _e1064, (_e1064 > 0i)) * _e1074);
let _e1155 = (select(_e1101, _e1107, (_e1107 < _e1101)) * _e1074);
let _e1156 = (select(_e1101, _e1110, (_e1110 < _e1101)) * _e1074);
local_4 = type_18(array<i32, 4>(_e1136, _e1136, _e1136, _e1136), array<u32, 6>(bitcast<u32>(((_e1123 - _e1136) * 8i)), bitcast<u32>(((select(0i, _e1034, (_e1034 > 0i)) - _e1136) * 8i)), bitcast<u32>(((select(_e1120, _e1126, (_e1126 < _e1120)) - _e1136) * 8i)), bitcast<u32>(((select(_e1120, _e1129, (_e1129 < _e1120)) - _e1136) * 8i)), 0u, 0u));
local_5 = vec3<f32>((_e470 - f32(_e1034)), (_e480 - f32(_e1049)), (_e490 - f32(_e1064)));
let _e1171 = local_4.member[0u];
let _e1172 = ((_e1154 + _e1150) + _e1171);
let _e1174 = (_e1172 >> bitcast<u32>(2i));
let _e1177 = bitcast<u32>(((_e1172 & 3i) * 8i));
let _e1179 = (bitcast<i32>(_e92) - 1i);
let _e1181 = select(_e1179, _e1174, (_e1174 < _e1179));
let _e1186 = global_2.member[bitcast<u32>(select(0i, _e1181, (_e1181 > 0i)))];
let _e1190 = (_e1174 + 1i);
let _e1192 = select(_e1179, _e1190, (_e1190 < _e1179));
let _e1197 = global_2.member[bitcast<u32>(select(0i, _e1192, (_e1192 > 0i)))];
let _e1204 = ((_e1186 >> bitcast<u32>((_e1177 & 31u))) | ((_e1197 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1177) & 31u))));
let _e1207 = local_4.member_1[0u];
let _e1213 = f32(bitcast<i32>(((_e1204 >> bitcast<u32>((_e1207 & 31u))) & 255u)));
let _e1216 = local_4.member_1[1u];
let _e1222 = f32(bitcast<i32>(((_e1204 >> bitcast<u32>((_e1216 & 31u))) & 255u)));
let _e1225 = local_4.member_1[2u];
let _e1231 = f32(bitcast<i32>(((_e1204 >> bitcast<u32>((_e1225 & 31u))) & 255u)));
let _e1234 = local_4.member_1[3u];
let _e1241 = local_5[0u];
let _e1244 = (_e1213 + ((_e1222 - _e1213) * _e1241));
let _e1245 = local_5[0u];
let _e1248 = (_e1222 + ((_e1231 - _e1222) * _e1245));
let _e1249 = local_5[0u];
let _e1252 = (_e1231 + ((f32(bitcast<i32>(((_e1204 >> bitcast<u32>((_e1234 & 31u))) & 255u))) - _e1231) * _e1249));
let _e1254 = local_4.member[0u];
let _e1255 = ((_e1154 + _e1151) + _e1254);
let _e1257 = (_e1255 >> bitcast<u32>(2i));
let _e1260 = bitcast<u32>(((_e1255 & 3i) * 8i));
let _e1262 = select(_e1179, _e1257, (_e1257 < _e1179));
let _e1267 = global_2.member[bitcast<u32>(select(0i, _e1262, (_e1262 > 0i)))];
let _e1271 = (_e1257 + 1i);
let _e1273 = select(_e1179, _e1271, (_e1271 < _e1179));
let _e1278 = global_2.member[bitcast<u32>(select(0i, _e1273, (_e1273 > 0i)))];
let _e1285 = ((_e1267 >> bitcast<u32>((_e1260 & 31u))) | ((_e1278 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1260) & 31u))));
let _e1286 = local_4.member_1[0u];
let _e1292 = f32(bitcast<i32>(((_e1285 >> bitcast<u32>((_e1286 & 31u))) & 255u)));
let _e1293 = local_4.member_1[1u];
let _e1299 = f32(bitcast<i32>(((_e1285 >> bitcast<u32>((_e1293 & 31u))) & 255u)));
let _e1300 = local_4.member_1[2u];
let _e1306 = f32(bitcast<i32>(((_e1285 >> bitcast<u32>((_e1300 & 31u))) & 255u)));
let _e1307 = local_4.member_1[3u];
let _e1314 = local_5[0u];
let _e1318 = local_5[0u];
let _e1321 = (_e1299 + ((_e1306 - _e1299) * _e1318));
let _e1322 = local_5[0u];
let _e1327 = local_4.member[0u];
let _e1328 = ((_e1155 + _e1150) + _e1327);
let _e1330 = (_e1328 >> bitcast<u32>(2i));
let _e1333 = bitcast<u32>(((_e1328 & 3i) * 8i));
let _e1335 = select(_e1179, _e1330, (_e1330 < _e1179));
let _e1340 = global_2.member[bitcast<u32>(select(0i, _e1335, (_e1335 > 0i)))];
let _e1344 = (_e1330 + 1i);
let _e1346 = select(_e1179, _e1344, (_e1344 < _e1179));
let _e1351 = global_2.member[bitcast<u32>(select(0i, _e1346, (_e1346 > 0i)))];
let _e1358 = ((_e1340 >> bitcast<u32>((_e1333 & 31u))) | ((_e1351 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1333) & 31u))));
let _e1359 = local_4.member_1[0u];
let _e1365 = f32(bitcast<i32>(((_e1358 >> bitcast<u32>((_e1359 & 31u))) & 255u)));
let _e1366 = local_4.member_1[1u];
let _e1372 = f32(bitcast<i32>(((_e1358 >> bitcast<u32>((_e1366 & 31u))) & 255u)));
let _e1373 = local_4.member_1[2u];
let _e1379 = f32(bitcast<i32>(((_e1358 >> bitcast<u32>((_e1373 & 31u))) & 255u)));
let _e1380 = local_4.member_1[3u];
let _e1387 = local_5[0u];
let _e1390 = (_e1365 + ((_e1372 - _e1365) * _e1387));
let _e1391 = local_5[0u];
let _e1394 = (_e1372 + ((_e1379 - _e1372) * _e1391));
let _e1395 = local_5[0u];
let _e1398 = (_e1379 + ((f32(bitcast<i32>(((_e1358 >> bitcast<u32>((_e1380 & 31u))) & 255u))) - _e1379) * _e1395));
let _e1400 = local_4.member[0u];
let _e1401 = ((_e1155 + _e1151) + _e1400);
let _e1403 = (_e1401 >> bitcast<u32>(2i));
let _e1406 = bitcast<u32>(((_e1401 & 3i) * 8i));
let _e1408 = select(_e1179, _e1403, (_e1403 < _e1179));
let _e1413 = global_2.member[bitcast<u32>(select(0i, _e1408, (_e1408 > 0i)))];
let _e1417 = (_e1403 + 1i);
let _e1419 = select(_e1179, _e1417, (_e1417 < _e1179));
let _e1424 = global_2.member[bitcast<u32>(select(0i, _e1419, (_e1419 > 0i)))];
let _e1431 = ((_e1413 >> bitcast<u32>((_e1406 & 31u))) | ((_e1424 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1406) & 31u))));
let _e1432 = local_4.member_1[0u];
let _e1438 = f32(bitcast<i32>(((_e1431 >> bitcast<u32>((_e1432 & 31u))) & 255u)));
let _e1439 = local_4.member_1[1u];
let _e1445 = f32(bitcast<i32>(((_e1431 >> bitcast<u32>((_e1439 & 31u))) & 255u)));
let _e1446 = local_4.member_1[2u];
let _e1452 = f32(bitcast<i32>(((_e1431 >> bitcast<u32>((_e1446 & 31u))) & 255u)));
let _e1453 = local_4.member_1[3u];
let _e1460 = local_5[0u];
let _e1464 = local_5[0u];
let _e1467 = (_e1445 + ((_e1452 - _e1445) * _e1464));
let _e1468 = local_5[0u];
let _e1473 = local_4.member[0u];
let _e1474 = ((_e1154 + _e1149) + _e1473);
let _e1476 = (_e1474 >> bitcast<u32>(2i));
let _e1479 = bitcast<u32>(((_e1474 & 3i) * 8i));
let _e1481 = select(_e1179, _e1476, (_e1476 < _e1179));
let _e1486 = global_2.member[bitcast<u32>(select(0i, _e1481, (_e1481 > 0i)))];
let _e1490 = (_e1476 + 1i);
let _e1492 = select(_e1179, _e1490, (_e1490 < _e1179));
let _e1497 = global_2.member[bitcast<u32>(select(0i, _e1492, (_e1492 > 0i)))];
let _e1504 = ((_e1486 >> bitcast<u32>((_e1479 & 31u))) | ((_e1497 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1479) & 31u))));
let _e1505 = local_4.member_1[1u];
let _e1511 = f32(bitcast<i32>(((_e1504 >> bitcast<u32>((_e1505 & 31u))) & 255u)));
let _e1512 = local_4.member_1[2u];
let _e1519 = local_5[0u];
let _e1522 = (_e1511 + ((f32(bitcast<i32>(((_e1504 >> bitcast<u32>((_e1512 & 31u))) & 255u))) - _e1511) * _e1519));
let _e1524 = local_4.member[0u];
let _e1525 = ((_e1154 + _e1152) + _e1524);
let _e1527 = (_e1525 >> bitcast<u32>(2i));
let _e1530 = bitcast<u32>(((_e1525 & 3i) * 8i));
let _e1532 = select(_e1179, _e1527, (_e1527 < _e1179));
let _e1537 = global_2.member[bitcast<u32>(select(0i, _e1532, (_e1532 > 0i)))];
let _e1541 = (_e1527 + 1i);
let _e1543 = select(_e1179, _e1541, (_e1541 < _e1179));
let _e1548 = global_2.member[bitcast<u32>(select(0i, _e1543, (_e1543 > 0i)))];
let _e1555 = ((_e1537 >> bitcast<u32>((_e1530 & 31u))) | ((_e1548 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1530) & 31u))));
let _e1556 = local_4.member_1[1u];
let _e1562 = f32(bitcast<i32>(((_e1555 >> bitcast<u32>((_e1556 & 31u))) & 255u)));
let _e1563 = local_4.member_1[2u];
let _e1570 = local_5[0u];
let _e1575 = local_4.member[0u];
let _e1576 = ((_e1155 + _e1149) + _e1575);
let _e1578 = (_e1576 >> bitcast<u32>(2i));
let _e1581 = bitcast<u32>(((_e1576 & 3i) * 8i));
let _e1583 = select(_e1179, _e1578, (_e1578 < _e1179));
let _e1588 = global_2.member[bitcast<u32>(select(0i, _e1583, (_e1583 > 0i)))];
let _e1592 = (_e1578 + 1i);
let _e1594 = select(_e1179, _e1592, (_e1592 < _e1179));
let _e1599 = global_2.member[bitcast<u32>(select(0i, _e1594, (_e1594 > 0i)))];
let _e1606 = ((_e1588 >> bitcast<u32>((_e1581 & 31u))) | ((_e1599 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1581) & 31u))));
let _e1607 = local_4.member_1[1u];
let _e1613 = f32(bitcast<i32>(((_e1606 >> bitcast<u32>((_e1607 & 31u))) & 255u)));
let _e1614 = local_4.member_1[2u];
let _e1621 = local_5[0u];
let _e1624 = (_e1613 + ((f32(bitcast<i32>(((_e1606 >> bitcast<u32>((_e1614 & 31u))) & 255u))) - _e1613) * _e1621));
let _e1626 = local_4.member[0u];
let _e1627 = ((_e1155 + _e1152) + _e1626);
let _e1629 = (_e1627 >> bitcast<u32>(2i));
let _e1632 = bitcast<u32>(((_e1627 & 3i) * 8i));
let _e1634 = select(_e1179, _e1629, (_e1629 < _e1179));
let _e1639 = global_2.member[bitcast<u32>(select(0i, _e1634, (_e1634 > 0i)))];
let _e1643 = (_e1629 + 1i);
let _e1645 = select(_e1179, _e1643, (_e1643 < _e1179));
let _e1650 = global_2.member[bitcast<u32>(select(0i, _e1645, (_e1645 > 0i)))];
let _e1657 = ((_e1639 >> bitcast<u32>((_e1632 & 31u))) | ((_e1650 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1632) & 31u))));
let _e1658 = local_4.member_1[1u];
let _e1664 = f32(bitcast<i32>(((_e1657 >> bitcast<u32>((_e1658 & 31u))) & 255u)));
let _e1665 = local_4.member_1[2u];
let _e1672 = local_5[0u];
let _e1677 = local_4.member[0u];
let _e1678 = ((_e1153 + _e1150) + _e1677);
let _e1680 = (_e1678 >> bitcast<u32>(2i));
let _e1683 = bitcast<u32>(((_e1678 & 3i) * 8i));
let _e1685 = select(_e1179, _e1680, (_e1680 < _e1179));
let _e1690 = global_2.member[bitcast<u32>(select(0i, _e1685, (_e1685 > 0i)))];
let _e1694 = (_e1680 + 1i);
let _e1696 = select(_e1179, _e1694, (_e1694 < _e1179));
let _e1701 = global_2.member[bitcast<u32>(select(0i, _e1696, (_e1696 > 0i)))];
let _e1708 = ((_e1690 >> bitcast<u32>((_e1683 & 31u))) | ((_e1701 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1683) & 31u))));
let _e1709 = local_4.member_1[1u];
let _e1715 = f32(bitcast<i32>(((_e1708 >> bitcast<u32>((_e1709 & 31u))) & 255u)));
let _e1716 = local_4.member_1[2u];
let _e1723 = local_5[0u];
let _e1726 = (_e1715 + ((f32(bitcast<i32>(((_e1708 >> bitcast<u32>((_e1716 & 31u))) & 255u))) - _e1715) * _e1723));
let _e1728 = local_4.member[0u];
let _e1729 = ((_e1156 + _e1150) + _e1728);
let _e1731 = (_e1729 >> bitcast<u32>(2i));
let _e1734 = bitcast<u32>(((_e1729 & 3i) * 8i));
let _e1736 = select(_e1179, _e1731, (_e1731 < _e1179));
let _e1741 = global_2.member[bitcast<u32>(select(0i, _e1736, (_e1736 > 0i)))];
let _e1745 = (_e1731 + 1i);
let _e1747 = select(_e1179, _e1745, (_e1745 < _e1179));
let _e1752 = global_2.member[bitcast<u32>(select(0i, _e1747, (_e1747 > 0i)))];
let _e1759 = ((_e1741 >> bitcast<u32>((_e1734 & 31u))) | ((_e1752 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1734) & 31u))));
let _e1760 = local_4.member_1[1u];
let _e1766 = f32(bitcast<i32>(((_e1759 >> bitcast<u32>((_e1760 & 31u))) & 255u)));
let _e1767 = local_4.member_1[2u];
let _e1774 = local_5[0u];
let _e1777 = (_e1766 + ((f32(bitcast<i32>(((_e1759 >> bitcast<u32>((_e1767 & 31u))) & 255u))) - _e1766) * _e1774));
let _e1779 = local_4.member[0u];
let _e1780 = ((_e1153 + _e1151) + _e1779);
let _e1782 = (_e1780 >> bitcast<u32>(2i));
let _e1785 = bitcast<u32>(((_e1780 & 3i) * 8i));
let _e1787 = select(_e1179, _e1782, (_e1782 < _e1179));
let _e1792 = global_2.member[bitcast<u32>(select(0i, _e1787, (_e1787 > 0i)))];
let _e1796 = (_e1782 + 1i);
let _e1798 = select(_e1179, _e1796, (_e1796 < _e1179));
let _e1803 = global_2.member[bitcast<u32>(select(0i, _e1798, (_e1798 > 0i)))];
let _e1810 = ((_e1792 >> bitcast<u32>((_e1785 & 31u))) | ((_e1803 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1785) & 31u))));
let _e1811 = local_4.member_1[1u];
let _e1817 = f32(bitcast<i32>(((_e1810 >> bitcast<u32>((_e1811 & 31u))) & 255u)));
let _e1818 = local_4.member_1[2u];
let _e1825 = local_5[0u];
let _e1830 = local_4.member[0u];
let _e1831 = ((_e1156 + _e1151) + _e1830);
let _e1833 = (_e1831 >> bitcast<u32>(2i));
let _e1836 = bitcast<u32>(((_e1831 & 3i) * 8i));
let _e1838 = select(_e1179, _e1833, (_e1833 < _e1179));
let _e1843 = global_2.member[bitcast<u32>(select(0i, _e1838, (_e1838 > 0i)))];
let _e1847 = (_e1833 + 1i);
let _e1849 = select(_e1179, _e1847, (_e1847 < _e1179));
let _e1854 = global_2.member[bitcast<u32>(select(0i, _e1849, (_e1849 > 0i)))];
let _e1861 = ((_e1843 >> bitcast<u32>((_e1836 & 31u))) | ((_e1854 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1836) & 31u))));
let _e1862 = local_4.member_1[1u];
let _e1868 = f32(bitcast<i32>(((_e1861 >> bitcast<u32>((_e1862 & 31u))) & 255u)));
let _e1869 = local_4.member_1[2u];
let _e1876 = local_5[0u];
let _e1881 = local_5[1u];
let _e1884 = (_e1248 + ((_e1321 - _e1248) * _e1881));
let _e1885 = local_5[1u];
let _e1888 = (_e1394 + ((_e1467 - _e1394) * _e1885));
let _e1889 = local_5[1u];
let _e1892 = (_e1244 + (((_e1292 + ((_e1299 - _e1292) * _e1314)) - _e1244) * _e1889));
let _e1893 = local_5[1u];
let _e1898 = local_5[2u];
let _e1902 = local_5[1u];
let _e1905 = (_e1252 + (((_e1306 + ((f32(bitcast<i32>(((_e1285 >> bitcast<u32>((_e1307 & 31u))) & 255u))) - _e1306) * _e1322)) - _e1252) * _e1902));
let _e1906 = local_5[1u];
let _e1910 = local_5[2u];
let _e1914 = local_5[1u];
let _e1917 = (_e1522 + ((_e1248 - _e1522) * _e1914));
let _e1918 = local_5[1u];
let _e1922 = local_5[2u];
let _e1926 = local_5[1u];
let _e1929 = (_e1321 + (((_e1562 + ((f32(bitcast<i32>(((_e1555 >> bitcast<u32>((_e1563 & 31u))) & 255u))) - _e1562) * _e1570)) - _e1321) * _e1926));
let _e1930 = local_5[1u];
let _e1934 = local_5[2u];
let _e1938 = local_5[1u];
let _e1941 = (_e1726 + (((_e1817 + ((f32(bitcast<i32>(((_e1810 >> bitcast<u32>((_e1818 & 31u))) & 255u))) - _e1817) * _e1825)) - _e1726) * _e1938));
let _e1942 = local_5[2u];
let _e1946 = local_5[1u];
let _e1950 = local_5[2u];
let _e1954 = local_5[2u];
let _e1962 = global_1.member.member_5.member_4.member;
let _e1968 = global_1.member.member_5.member_4.member_1;
let _e1969 = (((_e1884 + ((_e1888 - _e1884) * _e1954)) * _e1962) + _e1968);
let _e1971 = select(0f, _e1969, (_e1969 > 0f));
let _e1973 = select(1f, _e1971, (_e1971 < 1f));
let _e1975 = (((_e1892 + (((_e1390 + (((_e1438 + ((_e1445 - _e1438) * _e1460)) - _e1390) * _e1893)) - _e1892) * _e1898)) * _e1962) + _e1968);
let _e1977 = select(0f, _e1975, (_e1975 > 0f));
let _e1979 = select(1f, _e1977, (_e1977 < 1f));
let _e1981 = (((_e1905 + (((_e1398 + (((_e1452 + ((f32(bitcast<i32>(((_e1431 >> bitcast<u32>((_e1453 & 31u))) & 255u))) - _e1452) * _e1468)) - _e1398) * _e1906)) - _e1905) * _e1910)) * _e1962) + _e1968);
let _e1983 = select(0f, _e1981, (_e1981 > 0f));
let _e1985 = select(1f, _e1983, (_e1983 < 1f));
let _e1987 = (((_e1917 + (((_e1624 + ((_e1394 - _e1624) * _e1918)) - _e1917) * _e1922)) * _e1962) + _e1968);
let _e1989 = select(0f, _e1987, (_e1987 > 0f));
let _e1991 = select(1f, _e1989, (_e1989 < 1f));
let _e1993 = (((_e1929 + (((_e1467 + (((_e1664 + ((f32(bitcast<i32>(((_e1657 >> bitcast<u32>((_e1665 & 31u))) & 255u))) - _e1664) * _e1672)) - _e1467) * _e1930)) - _e1929) * _e1934)) * _e1962) + _e1968);
let _e1995 = select(0f, _e1993, (_e1993 > 0f));
let _e1997 = select(1f, _e1995, (_e1995 < 1f));
let _e1999 = (((_e1941 + ((_e1884 - _e1941) * _e1942)) * _e1962) + _e1968);
let _e2001 = select(0f, _e1999, (_e1999 > 0f));
let _e2003 = select(1f, _e2001, (_e2001 < 1f));
let _e2005 = (((_e1888 + (((_e1777 + (((_e1868 + ((f32(bitcast<i32>(((_e1861 >> bitcast<u32>((_e1869 & 31u))) & 255u))) - _e1868) * _e1876)) - _e1777) * _e1946)) - _e1888) * _e1950)) * _e1962) + _e1968);
let _e2007 = select(0f, _e2005, (_e2005 > 0f));
let _e2009 = select(1f, _e2007, (_e2007 < 1f));
let _e2010 = (_e1973 * 1024f);
let _e2011 = (1024f - 1f);
let _e2013 = select(0f, _e2010, (_e2010 > 0f));
let _e2015 = select(_e2011, _e2013, (_e2013 < _e2011));
let _e2022 = select(0i, select(select(i32(_e2015), i32(-2147483648), (_e2015 < -2147483600f)), 2147483647i, (_e2015 > 2147483500f)), (_e2015 == _e2015));
let _e2026 = (_e2022 - select(0i, 1i, (_e2015 < f32(_e2022))));
let _e2027 = (262147i + _e2026);
let _e2029 = (bitcast<i32>(_e96) - 1i);
let _e2031 = select(_e2029, _e2027, (_e2027 < _e2029));
let _e2037 = global_4.member[bitcast<u32>(select(0i, _e2031, (_e2031 > 0i)))];
let _e2047 = select(_e2029, 262146i, (262146i < _e2029));
let _e2053 = global_4.member[bitcast<u32>(select(0i, _e2047, (_e2047 > 0i)))];
let _e2054 = bitcast<f32>(_e2053);
let _e2055 = (f32((bitcast<i32>((_e2037 & 4095u)) - 2048i)) * _e2054);
let _e2057 = select(_e2029, 262144i, (262144i < _e2029));
let _e2063 = global_4.member[bitcast<u32>(select(0i, _e2057, (_e2057 > 0i)))];
let _e2064 = bitcast<f32>(_e2063);
let _e2066 = select(_e2029, 262145i, (262145i < _e2029));
let _e2072 = global_4.member[bitcast<u32>(select(0i, _e2066, (_e2066 > 0i)))];
let _e2073 = bitcast<f32>(_e2072);
let _e2079 = ((_e2064 + (f32(bitcast<i32>((_e2037 >> bitcast<u32>(12u)))) * _e2073)) + (_e2055 * (_e2010 - f32(_e2026))));
let _e2080 = (_e2055 * 1024f);
if _e641 {
let _e2345 = ((0.5f * (_e1985 - _e1979)) * _e2080);
let _e2346 = ((0.5f * (_e1997 - _e1991)) * _e2080);
let _e2347 = ((0.5f * (_e2009 - _e2003)) * _e2080);
phi_5858_ = type_19(_e2079, vec3<f32>(_e2345, _e2346, _e2347), vec3<f32>((_e2345 * _e2079), (_e2346 * _e2079), (_e2347 * _e2079)));
} else {
let _e2081 = (_e1979 * 1024f);
let _e2083 = select(0f, _e2081, (_e2081 > 0f));
let _e2085 = select(_e2011, _e2083, (_e2083 < _e2011));
let _e2092 = select(0i, select(select(i32(_e2085), i32(-2147483648), (_e2085 < -2147483600f)), 2147483647i, (_e2085 > 2147483500f)), (_e2085 == _e2085));
let _e2096 = (_e2092 - select(0i, 1i, (_e2085 < f32(_e2092))));
let _e2097 = (262147i + _e2096);
let _e2099 = select(_e2029, _e2097, (_e2097 < _e2029));
let _e2105 = global_4.member[bitcast<u32>(select(0i, _e2099, (_e2099 > 0i)))];
let _e2120 = ((_e2064 + (f32(bitcast<i32>((_e2105 >> bitcast<u32>(12u)))) * _e2073)) + ((f32((bitcast<i32>((_e2105 & 4095u)) - 2048i)) * _e2054) * (_e2081 - f32(_e2096))));
let _e2121 = (_e1985 * 1024f);
let _e2123 = select(0f, _e2121, (_e2121 > 0f));
let _e2125 = select(_e2011, _e2123, (_e2123 < _e2011));
let _e2132 = select(0i, select(select(i32(_e2125), i32(-2147483648), (_e2125 < -2147483600f)), 2147483647i, (_e2125 > 2147483500f)), (_e2125 == _e2125));
let _e2136 = (_e2132 - select(0i, 1i, (_e2125 < f32(_e2132))));
let _e2137 = (262147i + _e2136);
let _e2139 = select(_e2029, _e2137, (_e2137 < _e2029));
let _e2145 = global_4.member[bitcast<u32>(select(0i, _e2139, (_e2139 > 0i)))];
let _e2160 = ((_e2064 + (f32(bitcast<i32>((_e2145 >> bitcast<u32>(12u)))) * _e2073)) + ((f32((bitcast<i32>((_e2145 & 4095u)) - 2048i)) * _e2054) * (_e2121 - f32(_e2136))));
let _e2161 = (_e1991 * 1024f);
let _e2163 = select(0f, _e2161, (_e2161 > 0f));
let _e2165 = select(_e2011, _e2163, (_e2163 < _e2011));
let _e2172 = select(0i, select(select(i32(_e2165), i32(-2147483648), (_e2165 < -2147483600f)), 2147483647i, (_e2165 > 2147483500f)), (_e2165 == _e2165));
let _e2176 = (_e2172 - select(0i, 1i, (_e2165 < f32(_e2172))));
let _e2177 = (262147i + _e2176);
let _e2179 = select(_e2029, _e2177, (_e2177 < _e2029));
let _e2185 = global_4.member[bitcast<u32>(select(0i, _e2179, (_e2179 > 0i)))];
let _e2200 = ((_e2064 + (f32(bitcast<i32>((_e2185 >> bitcast<u32>(12u)))) * _e2073)) + ((f32((bitcast<i32>((_e2185 & 4095u)) - 2048i)) * _e2054) * (_e2161 - f32(_e2176))));
let _e2201 = (_e1997 * 1024f);
let _e2203 = select(0f, _e2201, (_e2201 > 0f));
let _e2205 = select(_e2011, _e2203, (_e2203 < _e2011));
let _e2212 = select(0i, select(select(i32(_e2205), i32(-2147483648), (_e2205 < -2147483600f)), 2147483647i, (_e2205 > 2147483500f)), (_e2205 == _e2205));
let _e2216 = (_e2212 - select(0i, 1i, (_e2205 < f32(_e2212))));
let _e2217 = (262147i + _e2216);
let _e2219 = select(_e2029, _e2217, (_e2217 < _e2029));
let _e2225 = global_4.member[bitcast<u32>(select(0i, _e2219, (_e2219 > 0i)))];
let _e2240 = ((_e2064 + (f32(bitcast<i32>((_e2225 >> bitcast<u32>(12u)))) * _e2073)) + ((f32((bitcast<i32>((_e2225 & 4095u)) - 2048i)) * _e2054) * (_e2201 - f32(_e2216))));
let _e2241 = (_e2003 * 1024f);
let _e2243 = select(0f, _e2241, (_e2241 > 0f));
let _e2245 = select(_e2011, _e2243, (_e2243 < _e2011));
let _e2252 = select(0i, select(select(i32(_e2245), i32(-2147483648), (_e2245 < -2147483600f)), 2147483647i, (_e2245 > 2147483500f)), (_e2245 == _e2245));
let _e2256 = (_e2252 - select(0i, 1i, (_e2245 < f32(_e2252))));
let _e2257 = (262147i + _e2256);
let _e2259 = select(_e2029, _e2257, (_e2257 < _e2029));
let _e2265 = global_4.member[bitcast<u32>(select(0i, _e2259, (_e2259 > 0i)))];
let _e2280 = ((_e2064 + (f32(bitcast<i32>((_e2265 >> bitcast<u32>(12u)))) * _e2073)) + ((f32((bitcast<i32>((_e2265 & 4095u)) - 2048i)) * _e2054) * (_e2241 - f32(_e2256))));
let _e2281 = (_e2009 * 1024f);
let _e2283 = select(0f, _e2281, (_e2281 > 0f));
let _e2285 = select(_e2011, _e2283, (_e2283 < _e2011));
let _e2292 = select(0i, select(select(i32(_e2285), i32(-2147483648), (_e2285 < -2147483600f)), 2147483647i, (_e2285 > 2147483500f)), (_e2285 == _e2285));
let _e2296 = (_e2292 - select(0i, 1i, (_e2285 < f32(_e2292))));
let _e2297 = (262147i + _e2296);
let _e2299 = select(_e2029, _e2297, (_e2297 < _e2029));
let _e2305 = global_4.member[bitcast<u32>(select(0i, _e2299, (_e2299 > 0i)))];
let _e2320 = ((_e2064 + (f32(bitcast<i32>((_e2305 >> bitcast<u32>(12u)))) * _e2073)) + ((f32((bitcast<i32>((_e2305 & 4095u)) - 2048i)) * _e2054) * (_e2281 - f32(_e2296))));
let _e2321 = (_e2160 - _e2120);
let _e2323 = (_e2240 - _e2200);
let _e2325 = (_e2320 - _e2280);
phi_5858_ = type_19(_e2079, vec3<f32>((0.5f * _e2321), (0.5f * _e2323), (0.5f * _e2325)), vec3<f32>((0.25f * (_e2321 * (_e2160 + _e2120))), (0.25f * (_e2323 * (_e2240 + _e2200))), (0.25f * (_e2325 * (_e2320 + _e2280)))));
}
let _e2355 = phi_5858_;
let _e2370 = select(0f, 1f, ((((((_e443 >= -0.5f) && (_e443 <= _e466)) && (_e449 >= -0.5f)) && (_e449 <= _e476)) && (_e455 >= -0.5f)) && (_e455 <= _e486)));
let _e2372 = (0.5f * (_e1985 - _e1979));
let _e2374 = (0.5f * (_e1997 - _e1991));
let _e2376 = (0.5f * (_e2009 - _e2003));
let _e2381 = global_1.member.member_5.member.member;
let _e2387 = global_1.member.member_5.member_1.member;
let _e2394 = global_1.member.member_5.member_2.member;
let _e2401 = global_1.member.member_5.member.member_1;
let _e2407 = global_1.member.member_5.member_1.member_1;
let _e2414 = global_1.member.member_5.member_2.member_1;
let _e2421 = global_1.member.member_5.member.member_2;
let _e2427 = global_1.member.member_5.member_1.member_2;
let _e2434 = global_1.member.member_5.member_2.member_2;
phi_7202_ = type_20(_e1973, vec3<f32>(((((_e2381 * _e2372) + (_e2387 * _e2374)) + (_e2394 * _e2376)) * _e2370), ((((_e2401 * _e2372) + (_e2407 * _e2374)) + (_e2414 * _e2376)) * _e2370), ((((_e2421 * _e2372) + (_e2427 * _e2374)) + (_e2434 * _e2376)) * _e2370)), _e2355.member, vec3<f32>(((((_e2381 * _e2355.member_2.x) + (_e2387 * _e2355.member_2.y)) + (_e2394 * _e2355.member_2.z)) * _e2370), ((((_e2401 * _e2355.member_2.x) + (_e2407 * _e2355.member_2.y)) + (_e2414 * _e2355.member_2.z)) * _e2370), ((((_e2421 * _e2355.member_2.x) + (_e2427 * _e2355.member_2.y)) + (_e2434 * _e2355.member_2.z)) * _e2370)), vec3<f32>(((((_e2381 * _e2355.member_1.x) + (_e2387 * _e2355.member_1.y)) + (_e2394 * _e2355.member_1.z)) * _e2370), ((((_e2401 * _e2355.member_1.x) + (_e2407 * _e2355.member_1.y)) + (_e2414 * _e2355.member_1.z)) * _e2370), ((((_e2421 * _e2355.member_1.x) + (_e2427 * _e2355.member_1.y)) + (_e2434 * _e2355.member_1.z)) * _e2370)));
} else {
let _e646 = select(-1f, _e470, (_e470 > -1f));
let _e648 = select(_e465, _e646, (_e646 < _e465));
let _e655 = select(0i, select(select(i32(_e648), i32(-2147483648), (_e648 < -2147483600f)), 2147483647i, (_e648 > 2147483500f)), (_e648 == _e648));
let _e659 = (_e655 - select(0i, 1i, (_e648 < f32(_e655))));
let _e661 = select(-1f, _e480, (_e480 > -1f));
let _e663 = select(_e475, _e661, (_e661 < _e475));
let _e670 = select(0i, select(select(i32(_e663), i32(-2147483648), (_e663 < -2147483600f)), 2147483647i, (_e663 > 2147483500f)), (_e663 == _e663));
let _e674 = (_e670 - select(0i, 1i, (_e663 < f32(_e670))));
let _e676 = select(-1f, _e490, (_e490 > -1f));
let _e678 = select(_e485, _e676, (_e676 < _e485));
let _e685 = select(0i, select(select(i32(_e678), i32(-2147483648), (_e678 < -2147483600f)), 2147483647i, (_e678 > 2147483500f)), (_e678 == _e678));
let _e689 = (_e685 - select(0i, 1i, (_e678 < f32(_e685))));
let _e694 = global_1.member.member_5.member_5[0u];
let _e699 = global_1.member.member_5.member_5[1u];
let _e707 = (select(0i, select(select(i32(_e475), i32(-2147483648), (_e475 < -2147483600f)), 2147483647i, (_e475 > 2147483500f)), (_e475 == _e475)) - 1i);
let _e710 = (_e674 + 1i);
let _e720 = (select(0i, select(select(i32(_e485), i32(-2147483648), (_e485 < -2147483600f)), 2147483647i, (_e485 > 2147483500f)), (_e485 == _e485)) - 1i);
let _e723 = (_e689 + 1i);
let _e732 = select(0i, select(select(i32(_e465), i32(-2147483648), (_e465 < -2147483600f)), 2147483647i, (_e465 > 2147483500f)), (_e465 == _e465));
let _e733 = (_e732 - 1i);
let _e734 = (_e659 - 1i);
let _e736 = select(0i, _e734, (_e734 > 0i));
let _e739 = (_e659 + 1i);
let _e742 = (_e659 + 2i);
let _e745 = (_e732 - 4i);
let _e747 = select(0i, _e745, (_e745 > 0i));
let _e749 = select(_e747, _e736, (_e736 < _e747));
let _e762 = (select(0i, _e674, (_e674 > 0i)) * _e694);
let _e763 = (select(_e707, _e710, (_e710 < _e707)) * _e694);
let _e764 = (select(0i, _e689, (_e689 > 0i)) * _e699);
let _e765 = (select(_e720, _e723, (_e723 < _e720)) * _e699);
local_2 = type_18(array<i32, 4>(_e749, _e749, _e749, _e749), array<u32, 6>(bitcast<u32>(((_e736 - _e749) * 8i)), bitcast<u32>(((select(0i, _e659, (_e659 > 0i)) - _e749) * 8i)), bitcast<u32>(((select(_e733, _e739, (_e739 < _e733)) - _e749) * 8i)), bitcast<u32>(((select(_e733, _e742, (_e742 < _e733)) - _e749) * 8i)), 0u, 0u));
local_3 = vec3<f32>((_e470 - f32(_e659)), (_e480 - f32(_e674)), (_e490 - f32(_e689)));
let _e780 = local_2.member[0u];
let _e781 = ((_e764 + _e762) + _e780);
let _e783 = (_e781 >> bitcast<u32>(2i));
let _e786 = bitcast<u32>(((_e781 & 3i) * 8i));
let _e788 = (bitcast<i32>(_e92) - 1i);
let _e790 = select(_e788, _e783, (_e783 < _e788));
let _e795 = global_2.member[bitcast<u32>(select(0i, _e790, (_e790 > 0i)))];
let _e799 = (_e783 + 1i);
let _e801 = select(_e788, _e799, (_e799 < _e788));
let _e806 = global_2.member[bitcast<u32>(select(0i, _e801, (_e801 > 0i)))];
let _e813 = ((_e795 >> bitcast<u32>((_e786 & 31u))) | ((_e806 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e786) & 31u))));
let _e816 = local_2.member_1[1u];
let _e822 = f32(bitcast<i32>(((_e813 >> bitcast<u32>((_e816 & 31u))) & 255u)));
let _e825 = local_2.member_1[2u];
let _e832 = local_3[0u];
let _e835 = (_e822 + ((f32(bitcast<i32>(((_e813 >> bitcast<u32>((_e825 & 31u))) & 255u))) - _e822) * _e832));
let _e837 = local_2.member[0u];
let _e838 = ((_e764 + _e763) + _e837);
let _e840 = (_e838 >> bitcast<u32>(2i));
let _e843 = bitcast<u32>(((_e838 & 3i) * 8i));
let _e845 = select(_e788, _e840, (_e840 < _e788));
let _e850 = global_2.member[bitcast<u32>(select(0i, _e845, (_e845 > 0i)))];
let _e854 = (_e840 + 1i);
let _e856 = select(_e788, _e854, (_e854 < _e788));
let _e861 = global_2.member[bitcast<u32>(select(0i, _e856, (_e856 > 0i)))];
let _e868 = ((_e850 >> bitcast<u32>((_e843 & 31u))) | ((_e861 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e843) & 31u))));
let _e869 = local_2.member_1[1u];
let _e875 = f32(bitcast<i32>(((_e868 >> bitcast<u32>((_e869 & 31u))) & 255u)));
let _e876 = local_2.member_1[2u];
let _e883 = local_3[0u];
let _e888 = local_3[1u];
let _e891 = (_e835 + (((_e875 + ((f32(bitcast<i32>(((_e868 >> bitcast<u32>((_e876 & 31u))) & 255u))) - _e875) * _e883)) - _e835) * _e888));
let _e893 = local_2.member[0u];
let _e894 = ((_e765 + _e762) + _e893);
let _e896 = (_e894 >> bitcast<u32>(2i));
let _e899 = bitcast<u32>(((_e894 & 3i) * 8i));
let _e901 = select(_e788, _e896, (_e896 < _e788));
let _e906 = global_2.member[bitcast<u32>(select(0i, _e901, (_e901 > 0i)))];
let _e910 = (_e896 + 1i);
let _e912 = select(_e788, _e910, (_e910 < _e788));
let _e917 = global_2.member[bitcast<u32>(select(0i, _e912, (_e912 > 0i)))];
let _e924 = ((_e906 >> bitcast<u32>((_e899 & 31u))) | ((_e917 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e899) & 31u))));
let _e925 = local_2.member_1[1u];
let _e931 = f32(bitcast<i32>(((_e924 >> bitcast<u32>((_e925 & 31u))) & 255u)));
let _e932 = local_2.member_1[2u];
let _e939 = local_3[0u];
let _e942 = (_e931 + ((f32(bitcast<i32>(((_e924 >> bitcast<u32>((_e932 & 31u))) & 255u))) - _e931) * _e939));
let _e944 = local_2.member[0u];
let _e945 = ((_e765 + _e763) + _e944);
let _e947 = (_e945 >> bitcast<u32>(2i));
let _e950 = bitcast<u32>(((_e945 & 3i) * 8i));
let _e952 = select(_e788, _e947, (_e947 < _e788));
let _e957 = global_2.member[bitcast<u32>(select(0i, _e952, (_e952 > 0i)))];
let _e961 = (_e947 + 1i);
let _e963 = select(_e788, _e961, (_e961 < _e788));
let _e968 = global_2.member[bitcast<u32>(select(0i, _e963, (_e963 > 0i)))];
let _e975 = ((_e957 >> bitcast<u32>((_e950 & 31u))) | ((_e968 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e950) & 31u))));
let _e976 = local_2.member_1[1u];
let _e982 = f32(bitcast<i32>(((_e975 >> bitcast<u32>((_e976 & 31u))) & 255u)));
let _e983 = local_2.member_1[2u];
let _e990 = local_3[0u];
let _e994 = local_3[1u];
let _e999 = local_3[2u];
let _e1007 = global_1.member.member_5.member_4.member;
let _e1013 = global_1.member.member_5.member_4.member_1;
let _e1014 = (((_e891 + (((_e942 + (((_e982 + ((f32(bitcast<i32>(((_e975 >> bitcast<u32>((_e983 & 31u))) & 255u))) - _e982) * _e990)) - _e942) * _e994)) - _e891) * _e999)) * _e1007) + _e1013);
let _e1016 = select(0f, _e1014, (_e1014 > 0f));
phi_7202_ = type_20(select(1f, _e1016, (_e1016 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2487 = phi_7202_;
let _e2489 = select(-0.5f, _e401, (_e401 > -0.5f));
let _e2491 = select(_e466, _e2489, (_e2489 < _e466));
let _e2493 = select(-0.5f, _e419, (_e419 > -0.5f));
let _e2495 = select(_e476, _e2493, (_e2493 < _e476));
let _e2497 = select(-0.5f, _e437, (_e437 > -0.5f));
let _e2499 = select(_e486, _e2497, (_e2497 < _e486));
let _e2501 = select(-1f, _e2491, (_e2491 > -1f));
let _e2503 = select(_e465, _e2501, (_e2501 < _e465));
let _e2510 = select(0i, select(select(i32(_e2503), i32(-2147483648), (_e2503 < -2147483600f)), 2147483647i, (_e2503 > 2147483500f)), (_e2503 == _e2503));
let _e2514 = (_e2510 - select(0i, 1i, (_e2503 < f32(_e2510))));
let _e2516 = select(-1f, _e2495, (_e2495 > -1f));
let _e2518 = select(_e475, _e2516, (_e2516 < _e475));
let _e2525 = select(0i, select(select(i32(_e2518), i32(-2147483648), (_e2518 < -2147483600f)), 2147483647i, (_e2518 > 2147483500f)), (_e2518 == _e2518));
let _e2529 = (_e2525 - select(0i, 1i, (_e2518 < f32(_e2525))));
let _e2531 = select(-1f, _e2499, (_e2499 > -1f));
let _e2533 = select(_e485, _e2531, (_e2531 < _e485));
let _e2540 = select(0i, select(select(i32(_e2533), i32(-2147483648), (_e2533 < -2147483600f)), 2147483647i, (_e2533 > 2147483500f)), (_e2533 == _e2533));
let _e2544 = (_e2540 - select(0i, 1i, (_e2533 < f32(_e2540))));
let _e2549 = global_1.member.member_5.member_5[0u];
let _e2554 = global_1.member.member_5.member_5[1u];
let _e2562 = (select(0i, select(select(i32(_e475), i32(-2147483648), (_e475 < -2147483600f)), 2147483647i, (_e475 > 2147483500f)), (_e475 == _e475)) - 1i);
let _e2565 = (_e2529 + 1i);
let _e2575 = (select(0i, select(select(i32(_e485), i32(-2147483648), (_e485 < -2147483600f)), 2147483647i, (_e485 > 2147483500f)), (_e485 == _e485)) - 1i);
let _e2578 = (_e2544 + 1i);
let _e2587 = select(0i, select(select(i32(_e465), i32(-2147483648), (_e465 < -2147483600f)), 2147483647i, (_e465 > 2147483500f)), (_e465 == _e465));
let _e2588 = (_e2587 - 1i);
let _e2589 = (_e2514 - 1i);
let _e2591 = select(0i, _e2589, (_e2589 > 0i));
let _e2594 = (_e2514 + 1i);
let _e2597 = (_e2514 + 2i);
let _e2600 = (_e2587 - 4i);
let _e2602 = select(0i, _e2600, (_e2600 > 0i));
let _e2604 = select(_e2602, _e2591, (_e2591 < _e2602));
let _e2617 = (select(0i, _e2529, (_e2529 > 0i)) * _e2549);
let _e2618 = (select(_e2562, _e2565, (_e2565 < _e2562)) * _e2549);
let _e2619 = (select(0i, _e2544, (_e2544 > 0i)) * _e2554);
let _e2620 = (select(_e2575, _e2578, (_e2578 < _e2575)) * _e2554);
local = type_18(array<i32, 4>(_e2604, _e2604, _e2604, _e2604), array<u32, 6>(bitcast<u32>(((_e2591 - _e2604) * 8i)), bitcast<u32>(((select(0i, _e2514, (_e2514 > 0i)) - _e2604) * 8i)), bitcast<u32>(((select(_e2588, _e2594, (_e2594 < _e2588)) - _e2604) * 8i)), bitcast<u32>(((select(_e2588, _e2597, (_e2597 < _e2588)) - _e2604) * 8i)), 0u, 0u));
local_1 = vec3<f32>((_e2491 - f32(_e2514)), (_e2495 - f32(_e2529)), (_e2499 - f32(_e2544)));
let _e2635 = local.member[0u];
let _e2636 = ((_e2619 + _e2617) + _e2635);
let _e2638 = (_e2636 >> bitcast<u32>(2i));
let _e2641 = bitcast<u32>(((_e2636 & 3i) * 8i));
let _e2643 = (bitcast<i32>(_e92) - 1i);
let _e2645 = select(_e2643, _e2638, (_e2638 < _e2643));
let _e2650 = global_2.member[bitcast<u32>(select(0i, _e2645, (_e2645 > 0i)))];
let _e2654 = (_e2638 + 1i);
let _e2656 = select(_e2643, _e2654, (_e2654 < _e2643));
let _e2661 = global_2.member[bitcast<u32>(select(0i, _e2656, (_e2656 > 0i)))];
let _e2668 = ((_e2650 >> bitcast<u32>((_e2641 & 31u))) | ((_e2661 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2641) & 31u))));
let _e2671 = local.member_1[1u];
let _e2677 = f32(bitcast<i32>(((_e2668 >> bitcast<u32>((_e2671 & 31u))) & 255u)));
let _e2680 = local.member_1[2u];
let _e2687 = local_1[0u];
let _e2690 = (_e2677 + ((f32(bitcast<i32>(((_e2668 >> bitcast<u32>((_e2680 & 31u))) & 255u))) - _e2677) * _e2687));
let _e2692 = local.member[0u];
let _e2693 = ((_e2619 + _e2618) + _e2692);
let _e2695 = (_e2693 >> bitcast<u32>(2i));
let _e2698 = bitcast<u32>(((_e2693 & 3i) * 8i));
let _e2700 = select(_e2643, _e2695, (_e2695 < _e2643));
let _e2705 = global_2.member[bitcast<u32>(select(0i, _e2700, (_e2700 > 0i)))];
let _e2709 = (_e2695 + 1i);
let _e2711 = select(_e2643, _e2709, (_e2709 < _e2643));
let _e2716 = global_2.member[bitcast<u32>(select(0i, _e2711, (_e2711 > 0i)))];
let _e2723 = ((_e2705 >> bitcast<u32>((_e2698 & 31u))) | ((_e2716 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2698) & 31u))));
let _e2724 = local.member_1[1u];
let _e2730 = f32(bitcast<i32>(((_e2723 >> bitcast<u32>((_e2724 & 31u))) & 255u)));
let _e2731 = local.member_1[2u];
let _e2738 = local_1[0u];
let _e2743 = local_1[1u];
let _e2746 = (_e2690 + (((_e2730 + ((f32(bitcast<i32>(((_e2723 >> bitcast<u32>((_e2731 & 31u))) & 255u))) - _e2730) * _e2738)) - _e2690) * _e2743));
let _e2748 = local.member[0u];
let _e2749 = ((_e2620 + _e2617) + _e2748);
let _e2751 = (_e2749 >> bitcast<u32>(2i));
let _e2754 = bitcast<u32>(((_e2749 & 3i) * 8i));
let _e2756 = select(_e2643, _e2751, (_e2751 < _e2643));
let _e2761 = global_2.member[bitcast<u32>(select(0i, _e2756, (_e2756 > 0i)))];
let _e2765 = (_e2751 + 1i);
let _e2767 = select(_e2643, _e2765, (_e2765 < _e2643));
let _e2772 = global_2.member[bitcast<u32>(select(0i, _e2767, (_e2767 > 0i)))];
let _e2779 = ((_e2761 >> bitcast<u32>((_e2754 & 31u))) | ((_e2772 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2754) & 31u))));
let _e2780 = local.member_1[1u];
let _e2786 = f32(bitcast<i32>(((_e2779 >> bitcast<u32>((_e2780 & 31u))) & 255u)));
let _e2787 = local.member_1[2u];
let _e2794 = local_1[0u];
let _e2797 = (_e2786 + ((f32(bitcast<i32>(((_e2779 >> bitcast<u32>((_e2787 & 31u))) & 255u))) - _e2786) * _e2794));
let _e2799 = local.member[0u];
let _e2800 = ((_e2620 + _e2618) + _e2799);
let _e2802 = (_e2800 >> bitcast<u32>(2i));
let _e2805 = bitcast<u32>(((_e2800 & 3i) * 8i));
let _e2807 = select(_e2643, _e2802, (_e2802 < _e2643));
let _e2812 = global_2.member[bitcast<u32>(select(0i, _e2807, (_e2807 > 0i)))];
let _e2816 = (_e2802 + 1i);
let _e2818 = select(_e2643, _e2816, (_e2816 < _e2643));
let _e2823 = global_2.member[bitcast<u32>(select(0i, _e2818, (_e2818 > 0i)))];
let _e2830 = ((_e2812 >> bitcast<u32>((_e2805 & 31u))) | ((_e2823 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2805) & 31u))));
let _e2831 = local.member_1[1u];
let _e2837 = f32(bitcast<i32>(((_e2830 >> bitcast<u32>((_e2831 & 31u))) & 255u)));
let _e2838 = local.member_1[2u];
let _e2845 = local_1[0u];
let _e2849 = local_1[1u];
let _e2854 = local_1[2u];
let _e2862 = global_1.member.member_5.member_4.member;
let _e2868 = global_1.member.member_5.member_4.member_1;
let _e2869 = (((_e2746 + (((_e2797 + (((_e2837 + ((f32(bitcast<i32>(((_e2830 >> bitcast<u32>((_e2838 & 31u))) & 255u))) - _e2837) * _e2845)) - _e2797) * _e2849)) - _e2746) * _e2854)) * _e2862) + _e2868);
let _e2871 = select(0f, _e2869, (_e2869 > 0f));
if ((_e624 & 16u) == 0u) {
phi_8747_ = type_21(1f, 1f, 1f);
} else {
let _e2878 = global_1.member.member_18;
let _e2882 = global_1.member.member_22.member;
let _e2892 = ((((_e2878.member * _e309) + (_e2878.member_1 * _e318)) + (_e2878.member_2 * _e291)) + _e2878.member_3);
let _e2898 = ((((_e2878.member * _e330) + (_e2878.member_1 * _e335)) + (_e2878.member_2 * _e324)) + _e2878.member_3);
let _e2900 = select(_e2898, _e2892, (_e2892 < _e2898));
let _e2902 = select(_e2898, _e2892, (_e2892 > _e2898));
let _e2904 = (_e2902 - _e2900);
let _e2907 = (-(_e2900) / select(1e-30f, _e2904, (_e2904 > 1e-30f)));
let _e2909 = select(0f, _e2907, (_e2907 > 0f));
let _e2915 = select(select(select(1f, _e2909, (_e2909 < 1f)), 1f, (_e2902 <= 0f)), 0f, (_e2900 > 0f));
let _e2917 = (_e2882 > 0.5f);
let _e2926 = global_1.member.member_19;
let _e2930 = global_1.member.member_22.member_1;
let _e2940 = ((((_e2926.member * _e309) + (_e2926.member_1 * _e318)) + (_e2926.member_2 * _e291)) + _e2926.member_3);
let _e2946 = ((((_e2926.member * _e330) + (_e2926.member_1 * _e335)) + (_e2926.member_2 * _e324)) + _e2926.member_3);
let _e2948 = select(_e2946, _e2940, (_e2940 < _e2946));
let _e2950 = select(_e2946, _e2940, (_e2940 > _e2946));
let _e2952 = (_e2950 - _e2948);
let _e2955 = (-(_e2948) / select(1e-30f, _e2952, (_e2952 > 1e-30f)));
let _e2957 = select(0f, _e2955, (_e2955 > 0f));
let _e2963 = select(select(select(1f, _e2957, (_e2957 < 1f)), 1f, (_e2950 <= 0f)), 0f, (_e2948 > 0f));
let _e2965 = (_e2930 > 0.5f);
let _e2974 = global_1.member.member_20;
let _e2978 = global_1.member.member_22.member_2;
let _e2988 = ((((_e2974.member * _e309) + (_e2974.member_1 * _e318)) + (_e2974.member_2 * _e291)) + _e2974.member_3);
let _e2994 = ((((_e2974.member * _e330) + (_e2974.member_1 * _e335)) + (_e2974.member_2 * _e324)) + _e2974.member_3);
let _e2996 = select(_e2994, _e2988, (_e2988 < _e2994));
let _e2998 = select(_e2994, _e2988, (_e2988 > _e2994));
let _e3000 = (_e2998 - _e2996);
let _e3003 = (-(_e2996) / select(1e-30f, _e3000, (_e3000 > 1e-30f)));
let _e3005 = select(0f, _e3003, (_e3003 > 0f));
let _e3011 = select(select(select(1f, _e3005, (_e3005 < 1f)), 1f, (_e2998 <= 0f)), 0f, (_e2996 > 0f));
let _e3013 = (_e2978 > 0.5f);
let _e3022 = global_1.member.member_21;
let _e3026 = global_1.member.member_22.member_3;
let _e3036 = ((((_e3022.member * _e309) + (_e3022.member_1 * _e318)) + (_e3022.member_2 * _e291)) + _e3022.member_3);
let _e3042 = ((((_e3022.member * _e330) + (_e3022.member_1 * _e335)) + (_e3022.member_2 * _e324)) + _e3022.member_3);
let _e3044 = select(_e3042, _e3036, (_e3036 < _e3042));
let _e3046 = select(_e3042, _e3036, (_e3036 > _e3042));
let _e3048 = (_e3046 - _e3044);
let _e3051 = (-(_e3044) / select(1e-30f, _e3048, (_e3048 > 1e-30f)));
let _e3053 = select(0f, _e3051, (_e3051 > 0f));
let _e3059 = select(select(select(1f, _e3053, (_e3053 < 1f)), 1f, (_e3046 <= 0f)), 0f, (_e3044 > 0f));
let _e3061 = (_e3026 > 0.5f);
phi_8747_ = type_21(((((1f * _e2915) * _e2963) * _e3011) * _e3059), ((((1f * select(1f, _e2915, _e2917)) * select(1f, _e2963, _e2965)) * select(1f, _e3011, _e3013)) * select(1f, _e3059, _e3061)), ((((1f * select(1f, 0f, (_e2917 && (_e2898 > 0f)))) * select(1f, 0f, (_e2965 && (_e2946 > 0f)))) * select(1f, 0f, (_e3013 && (_e2994 > 0f)))) * select(1f, 0f, (_e3061 && (_e3042 > 0f)))));
}
let _e3070 = phi_8747_;
let _e3071 = (_e330 - _e309);
let _e3072 = (_e335 - _e318);
let _e3073 = (_e324 - _e291);
let _e3078 = (((_e3071 * _e3071) + (_e3072 * _e3072)) + (_e3073 * _e3073));
let _e3082 = (_e496 < 1e-12f);
let _e3084 = (1f / select(_e491, 1f, _e3082));
let _e3086 = ((-0.5f - _e401) * _e3084);
let _e3088 = ((_e466 - _e401) * _e3084);
let _e3094 = select(_e3088, _e3086, (_e3086 < _e3088));
let _e3096 = select(0f, _e3094, (_e3094 > 0f));
let _e3099 = select(select(1f, _e3096, (_e3096 < 1f)), select(2f, 0f, ((_e401 >= -0.5f) && (_e401 <= _e466))), _e3082);
let _e3101 = select(_e3088, _e3086, (_e3086 > _e3088));
let _e3103 = select(0f, _e3101, (_e3101 > 0f));
let _e3106 = select(select(1f, _e3103, (_e3103 < 1f)), 1f, _e3082);
let _e3107 = (_e499 < 1e-12f);
let _e3109 = (1f / select(_e492, 1f, _e3107));
let _e3111 = ((-0.5f - _e419) * _e3109);
let _e3113 = ((_e476 - _e419) * _e3109);
let _e3119 = select(_e3113, _e3111, (_e3111 < _e3113));
let _e3121 = select(0f, _e3119, (_e3119 > 0f));
let _e3124 = select(select(1f, _e3121, (_e3121 < 1f)), select(2f, 0f, ((_e419 >= -0.5f) && (_e419 <= _e476))), _e3107);
let _e3126 = select(_e3113, _e3111, (_e3111 > _e3113));
let _e3128 = select(0f, _e3126, (_e3126 > 0f));
let _e3131 = select(select(1f, _e3128, (_e3128 < 1f)), 1f, _e3107);
let _e3132 = (_e504 < 1e-12f);
let _e3134 = (1f / select(_e493, 1f, _e3132));
let _e3136 = ((-0.5f - _e437) * _e3134);
let _e3138 = ((_e486 - _e437) * _e3134);
let _e3144 = select(_e3138, _e3136, (_e3136 < _e3138));
let _e3146 = select(0f, _e3144, (_e3144 > 0f));
let _e3149 = select(select(1f, _e3146, (_e3146 < 1f)), select(2f, 0f, ((_e437 >= -0.5f) && (_e437 <= _e486))), _e3132);
let _e3151 = select(_e3138, _e3136, (_e3136 > _e3138));
let _e3153 = select(0f, _e3151, (_e3151 > 0f));
let _e3156 = select(select(1f, _e3153, (_e3153 < 1f)), 1f, _e3132);
let _e3158 = select(_e3131, _e3106, (_e3106 < _e3131));
let _e3162 = select(_e3124, _e3099, (_e3099 > _e3124));
let _e3165 = (select(_e3156, _e3158, (_e3158 < _e3156)) - select(_e3149, _e3162, (_e3162 > _e3149)));
let _e3172 = global_1.member.member_4.member_3;
let _e3173 = ((sqrt(select(0f, _e3078, (_e3078 > 0f))) * select(0f, _e3165, (_e3165 > 0f))) * _e3172);
let _e3175 = (select(1f, _e2871, (_e2871 < 1f)) * 255f);
let _e3176 = (_e2487.member * 255f);
let _e3177 = (255f - 1f);
let _e3179 = select(0f, _e3175, (_e3175 > 0f));
let _e3181 = select(_e3177, _e3179, (_e3179 < _e3177));
let _e3188 = select(0i, select(select(i32(_e3181), i32(-2147483648), (_e3181 < -2147483600f)), 2147483647i, (_e3181 > 2147483500f)), (_e3181 == _e3181));
let _e3192 = (_e3188 - select(0i, 1i, (_e3181 < f32(_e3188))));
let _e3194 = select(0f, _e3176, (_e3176 > 0f));
let _e3196 = select(_e3177, _e3194, (_e3194 < _e3177));
let _e3203 = select(0i, select(select(i32(_e3196), i32(-2147483648), (_e3196 < -2147483600f)), 2147483647i, (_e3196 > 2147483500f)), (_e3196 == _e3196));
let _e3207 = (_e3203 - select(0i, 1i, (_e3196 < f32(_e3203))));
let _e3210 = (((_e3192 * 256i) + _e3207) * 4i);
let _e3212 = (_e3175 - f32(_e3192));
let _e3214 = (_e3176 - f32(_e3207));
let _e3216 = (bitcast<i32>(_e96) - 1i);
let _e3218 = select(_e3216, _e3210, (_e3210 < _e3216));
let _e3224 = global_4.member[bitcast<u32>(select(0i, _e3218, (_e3218 > 0i)))];
let _e3225 = (_e3210 + 4i);
let _e3227 = select(_e3216, _e3225, (_e3225 < _e3216));
let _e3233 = global_4.member[bitcast<u32>(select(0i, _e3227, (_e3227 > 0i)))];
let _e3234 = (_e3210 + 1024i);
let _e3236 = select(_e3216, _e3234, (_e3234 < _e3216));
let _e3242 = global_4.member[bitcast<u32>(select(0i, _e3236, (_e3236 > 0i)))];
let _e3243 = (_e3210 + 1028i);
let _e3245 = select(_e3216, _e3243, (_e3243 < _e3216));
let _e3251 = global_4.member[bitcast<u32>(select(0i, _e3245, (_e3245 > 0i)))];
let _e3256 = (bitcast<f32>(((_e3224 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3264 = (_e3256 + (((bitcast<f32>(((_e3233 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3256) * _e3214));
let _e3269 = (bitcast<f32>(((_e3242 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3293 = (bitcast<f32>((((_e3224 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3301 = (_e3293 + (((bitcast<f32>((((_e3233 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3293) * _e3214));
let _e3306 = (bitcast<f32>((((_e3242 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3318 = (_e3210 + 1i);
let _e3320 = select(_e3216, _e3318, (_e3318 < _e3216));
let _e3326 = global_4.member[bitcast<u32>(select(0i, _e3320, (_e3320 > 0i)))];
let _e3327 = (_e3210 + 5i);
let _e3329 = select(_e3216, _e3327, (_e3327 < _e3216));
let _e3335 = global_4.member[bitcast<u32>(select(0i, _e3329, (_e3329 > 0i)))];
let _e3336 = (_e3210 + 1025i);
let _e3338 = select(_e3216, _e3336, (_e3336 < _e3216));
let _e3344 = global_4.member[bitcast<u32>(select(0i, _e3338, (_e3338 > 0i)))];
let _e3345 = (_e3210 + 1029i);
let _e3347 = select(_e3216, _e3345, (_e3345 < _e3216));
let _e3353 = global_4.member[bitcast<u32>(select(0i, _e3347, (_e3347 > 0i)))];
let _e3358 = (bitcast<f32>(((_e3326 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3366 = (_e3358 + (((bitcast<f32>(((_e3335 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3358) * _e3214));
let _e3371 = (bitcast<f32>(((_e3344 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3395 = (bitcast<f32>((((_e3326 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3403 = (_e3395 + (((bitcast<f32>((((_e3335 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3395) * _e3214));
let _e3408 = (bitcast<f32>((((_e3344 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3423 = (_e3173 * _e3070.member_1);
let _e3425 = -(((_e3301 + (((_e3306 + (((bitcast<f32>((((_e3251 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3306) * _e3214)) - _e3301) * _e3212)) * _e3423));
let _e3427 = select(-87f, _e3425, (_e3425 > -87f));
let _e3429 = select(88f, _e3427, (_e3427 < 88f));
let _e3431 = ((_e3429 * 1.442695f) + 0.5f);
let _e3433 = select(-127f, _e3431, (_e3431 > -127f));
let _e3435 = select(128f, _e3433, (_e3433 < 128f));
let _e3442 = select(0i, select(select(i32(_e3435), i32(-2147483648), (_e3435 < -2147483600f)), 2147483647i, (_e3435 > 2147483500f)), (_e3435 == _e3435));
let _e3446 = (_e3442 - select(0i, 1i, (_e3435 < f32(_e3442))));
let _e3447 = f32(_e3446);
let _e3451 = ((_e3429 - (_e3447 * 0.6933594f)) - (_e3447 * -2.1219444e-4f));
let _e3473 = -(((_e3366 + (((_e3371 + (((bitcast<f32>(((_e3353 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3371) * _e3214)) - _e3366) * _e3212)) * _e3423));
let _e3475 = select(-87f, _e3473, (_e3473 > -87f));
let _e3477 = select(88f, _e3475, (_e3475 < 88f));
let _e3479 = ((_e3477 * 1.442695f) + 0.5f);
let _e3481 = select(-127f, _e3479, (_e3479 > -127f));
let _e3483 = select(128f, _e3481, (_e3481 < 128f));
let _e3490 = select(0i, select(select(i32(_e3483), i32(-2147483648), (_e3483 < -2147483600f)), 2147483647i, (_e3483 > 2147483500f)), (_e3483 == _e3483));
let _e3494 = (_e3490 - select(0i, 1i, (_e3483 < f32(_e3490))));
let _e3495 = f32(_e3494);
let _e3499 = ((_e3477 - (_e3495 * 0.6933594f)) - (_e3495 * -2.1219444e-4f));
let _e3521 = -(((_e3403 + (((_e3408 + (((bitcast<f32>((((_e3353 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3408) * _e3214)) - _e3403) * _e3212)) * _e3423));
let _e3523 = select(-87f, _e3521, (_e3521 > -87f));
let _e3525 = select(88f, _e3523, (_e3523 < 88f));
let _e3527 = ((_e3525 * 1.442695f) + 0.5f);
let _e3529 = select(-127f, _e3527, (_e3527 > -127f));
let _e3531 = select(128f, _e3529, (_e3529 < 128f));
let _e3538 = select(0i, select(select(i32(_e3531), i32(-2147483648), (_e3531 < -2147483600f)), 2147483647i, (_e3531 > 2147483500f)), (_e3531 == _e3531));
let _e3542 = (_e3538 - select(0i, 1i, (_e3531 < f32(_e3538))));
let _e3543 = f32(_e3542);
let _e3547 = ((_e3525 - (_e3543 * 0.6933594f)) - (_e3543 * -2.1219444e-4f));
let _e3569 = -(((_e3264 + (((_e3269 + (((bitcast<f32>(((_e3251 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3269) * _e3214)) - _e3264) * _e3212)) * (_e3173 * _e3070.member)));
let _e3571 = select(-87f, _e3569, (_e3569 > -87f));
let _e3573 = select(88f, _e3571, (_e3571 < 88f));
let _e3575 = ((_e3573 * 1.442695f) + 0.5f);
let _e3577 = select(-127f, _e3575, (_e3575 > -127f));
let _e3579 = select(128f, _e3577, (_e3577 < 128f));
let _e3586 = select(0i, select(select(i32(_e3579), i32(-2147483648), (_e3579 < -2147483600f)), 2147483647i, (_e3579 > 2147483500f)), (_e3579 == _e3579));
let _e3590 = (_e3586 - select(0i, 1i, (_e3579 < f32(_e3586))));
let _e3591 = f32(_e3590);
let _e3595 = ((_e3573 - (_e3591 * 0.6933594f)) - (_e3591 * -2.1219444e-4f));
let _e3615 = ((1f + (_e3595 * (1f + (_e3595 * (0.5f + (_e3595 * (0.16666667f + (_e3595 * (0.041666668f + (_e3595 * (0.008333334f + (_e3595 * (0.001388889f + (_e3595 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3590 + 127i)) << bitcast<u32>(23i))));
if _e644 {
let _e3630 = global_1.member.member_24.member_2;
let _e3633 = (_e2487.member_3.x * _e3070.member_2);
let _e3635 = (_e2487.member_3.y * _e3070.member_2);
let _e3637 = (_e2487.member_3.z * _e3070.member_2);
let _e3638 = (0.5f * (_e248 / _e200));
let _e3642 = (_e178 + (_e3633 * _e3638));
let _e3643 = (_e189 + (_e3635 * _e3638));
let _e3644 = (_e200 + (_e3637 * _e3638));
let _e3646 = (2f * _e248);
let _e3648 = ((_e3644 * _e3644) + (_e3646 * _e3637));
let _e3652 = (_e3644 + sqrt(select(0f, _e3648, (_e3648 > 0f))));
let _e3656 = (0.5f * (_e3646 / select(1e-6f, _e3652, (_e3652 > 1e-6f))));
let _e3660 = (_e3642 + (_e3633 * _e3656));
let _e3661 = (_e3643 + (_e3635 * _e3656));
let _e3662 = (_e3644 + (_e3637 * _e3656));
let _e3666 = (_e3630 * _e3630);
let _e3668 = (_e3662 * _e3662);
let _e3676 = (((_e3644 <= 0f) || (_e3648 <= 0f)) || ((_e3662 <= 0f) || (_e3668 <= (_e3666 * (((_e3660 * _e3660) + (_e3661 * _e3661)) + _e3668)))));
let _e3690 = (_e178 + ((_e2487.member_4.x * _e3070.member_2) * _e248));
let _e3691 = (_e189 + ((_e2487.member_4.y * _e3070.member_2) * _e248));
let _e3692 = (_e200 + ((_e2487.member_4.z * _e3070.member_2) * _e248));
let _e3694 = (_e3692 * _e3692);
let _e3703 = ((_e624 & 1u) != 0u);
phi_9771_ = select(select(select(_e3662, _e3644, _e3676), _e3692, _e3703), _e200, _e631);
phi_9772_ = select(select(select(_e3661, _e3643, _e3676), _e3691, _e3703), _e189, _e631);
phi_9773_ = select(select(select(_e3660, _e3642, _e3676), _e3690, _e3703), _e178, _e631);
phi_9774_ = (select(_e3676, ((_e3692 <= 0f) || (_e3694 <= (_e3666 * (((_e3690 * _e3690) + (_e3691 * _e3691)) + _e3694)))), _e3703) && !(_e631));
} else {
phi_9771_ = _e200;
phi_9772_ = _e189;
phi_9773_ = _e178;
phi_9774_ = false;
}
let _e3714 = phi_9771_;
let _e3716 = phi_9772_;
let _e3718 = phi_9773_;
let _e3720 = phi_9774_;
global_6.member[_e124] = (_e135 + _e263);
global_6.member[_e136] = (_e145 + _e270);
global_6.member[_e147] = (_e156 + _e372);
global_6.member[_e158] = (_e167 + _e375);
global_6.member[_e169] = _e3718;
global_6.member[_e180] = _e3716;
global_6.member[_e191] = _e3714;
global_6.member[_e202] = select((_e211 * (((1f + (_e3451 * (1f + (_e3451 * (0.5f + (_e3451 * (0.16666667f + (_e3451 * (0.041666668f + (_e3451 * (0.008333334f + (_e3451 * (0.001388889f + (_e3451 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3446 + 127i)) << bitcast<u32>(23i)))) * _e3615)), _e211, _e631);
global_6.member[_e213] = select((_e222 * (((1f + (_e3499 * (1f + (_e3499 * (0.5f + (_e3499 * (0.16666667f + (_e3499 * (0.041666668f + (_e3499 * (0.008333334f + (_e3499 * (0.001388889f + (_e3499 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3494 + 127i)) << bitcast<u32>(23i)))) * _e3615)), _e222, _e631);
global_6.member[_e224] = select((_e233 * (((1f + (_e3547 * (1f + (_e3547 * (0.5f + (_e3547 * (0.16666667f + (_e3547 * (0.041666668f + (_e3547 * (0.008333334f + (_e3547 * (0.001388889f + (_e3547 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3542 + 127i)) << bitcast<u32>(23i)))) * _e3615)), _e233, _e631);
global_6.member[_e235] = select(_e244, 1f, _e3720);
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
