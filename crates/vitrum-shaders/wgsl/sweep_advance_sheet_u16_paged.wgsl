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
var phi_5835_: type_19;
var phi_7155_: type_20;
var phi_8676_: type_21;
var phi_9700_: f32;
var phi_9701_: f32;
var phi_9702_: f32;
var phi_9703_: bool;
switch bitcast<i32>(0u) {
default: {
let _e90 = global;
let _e93 = arrayLength((&global_2.member));
let _e97 = arrayLength((&global_4.member));
let _e104 = global_1.member.member_1;
let _e107 = (_e90.x + _e104.x);
let _e110 = (_e90.y + _e104.y);
if (_e107 < _e104.z) {
if (_e110 < _e104.w) {
let _e118 = global_1.member.member[0u];
let _e122 = global_1.member.member[1u];
let _e123 = (_e118 * _e122);
let _e125 = ((_e110 * _e118) + _e107);
let _e126 = bitcast<i32>(_e125);
let _e128 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e130 = select(_e128, _e126, (_e126 < _e128));
let _e136 = global_6.member[bitcast<u32>(select(0i, _e130, (_e130 > 0i)))];
let _e137 = (_e123 + _e125);
let _e138 = bitcast<i32>(_e137);
let _e140 = select(_e128, _e138, (_e138 < _e128));
let _e146 = global_6.member[bitcast<u32>(select(0i, _e140, (_e140 > 0i)))];
let _e148 = ((2u * _e123) + _e125);
let _e149 = bitcast<i32>(_e148);
let _e151 = select(_e128, _e149, (_e149 < _e128));
let _e157 = global_6.member[bitcast<u32>(select(0i, _e151, (_e151 > 0i)))];
let _e159 = ((3u * _e123) + _e125);
let _e160 = bitcast<i32>(_e159);
let _e162 = select(_e128, _e160, (_e160 < _e128));
let _e168 = global_6.member[bitcast<u32>(select(0i, _e162, (_e162 > 0i)))];
let _e170 = ((4u * _e123) + _e125);
let _e171 = bitcast<i32>(_e170);
let _e173 = select(_e128, _e171, (_e171 < _e128));
let _e179 = global_6.member[bitcast<u32>(select(0i, _e173, (_e173 > 0i)))];
let _e181 = ((5u * _e123) + _e125);
let _e182 = bitcast<i32>(_e181);
let _e184 = select(_e128, _e182, (_e182 < _e128));
let _e190 = global_6.member[bitcast<u32>(select(0i, _e184, (_e184 > 0i)))];
let _e192 = ((6u * _e123) + _e125);
let _e193 = bitcast<i32>(_e192);
let _e195 = select(_e128, _e193, (_e193 < _e128));
let _e201 = global_6.member[bitcast<u32>(select(0i, _e195, (_e195 > 0i)))];
let _e203 = ((7u * _e123) + _e125);
let _e204 = bitcast<i32>(_e203);
let _e206 = select(_e128, _e204, (_e204 < _e128));
let _e212 = global_6.member[bitcast<u32>(select(0i, _e206, (_e206 > 0i)))];
let _e214 = ((8u * _e123) + _e125);
let _e215 = bitcast<i32>(_e214);
let _e217 = select(_e128, _e215, (_e215 < _e128));
let _e223 = global_6.member[bitcast<u32>(select(0i, _e217, (_e217 > 0i)))];
let _e225 = ((9u * _e123) + _e125);
let _e226 = bitcast<i32>(_e225);
let _e228 = select(_e128, _e226, (_e226 < _e128));
let _e234 = global_6.member[bitcast<u32>(select(0i, _e228, (_e228 > 0i)))];
let _e236 = ((10u * _e123) + _e125);
let _e237 = bitcast<i32>(_e236);
let _e239 = select(_e128, _e237, (_e237 < _e128));
let _e245 = global_6.member[bitcast<u32>(select(0i, _e239, (_e239 > 0i)))];
let _e249 = global_1.member.member_4.member_2;
let _e252 = (1f / select(1e-6f, _e201, (_e201 > 1e-6f)));
let _e256 = global_1.member.member_7.member_3;
let _e257 = (_e249 * _e256);
let _e262 = global_1.member.member_8.member;
let _e264 = (((_e179 * _e252) - _e262) * _e257);
let _e269 = global_1.member.member_8.member_1;
let _e271 = (((_e190 * _e252) - _e269) * _e257);
let _e275 = ((f32(bitcast<i32>(_e107)) - 0.5f) + _e136);
let _e279 = global_1.member.member_2[3u];
let _e280 = (_e279 + 1u);
let _e282 = select(1u, _e280, (_e280 > 0u));
let _e283 = (_e282 == 0u);
if _e283 {
break;
}
let _e288 = ((f32(bitcast<i32>((_e110 % _e282))) - 0.5f) + _e146);
let _e292 = global_1.member.member_4.member;
let _e296 = global_1.member.member_8.member_2;
let _e297 = (_e292 - _e296);
let _e301 = global_1.member.member_7.member;
let _e308 = global_1.member.member_7.member_2;
let _e310 = ((_e301 + (_e262 * _e297)) + ((_e275 + 0.5f) * _e308));
let _e314 = global_1.member.member_7.member_1;
let _e319 = ((_e314 + (_e269 * _e297)) + ((_e288 + 0.5f) * _e308));
let _e325 = global_1.member.member_4.member_1;
let _e326 = (_e325 - _e296);
let _e331 = ((_e301 + (_e262 * _e326)) + (((_e275 + _e264) + 0.5f) * _e308));
let _e336 = ((_e314 + (_e269 * _e326)) + (((_e288 + _e271) + 0.5f) * _e308));
if _e283 {
break;
}
let _e339 = bitcast<i32>(((_e110 / _e282) * 3u));
let _e341 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e343 = select(_e341, _e339, (_e339 < _e341));
let _e349 = global_5.member[bitcast<u32>(select(0i, _e343, (_e343 > 0i)))];
let _e350 = (_e339 + 1i);
let _e352 = select(_e341, _e350, (_e350 < _e341));
let _e358 = global_5.member[bitcast<u32>(select(0i, _e352, (_e352 > 0i)))];
let _e359 = (_e339 + 2i);
let _e361 = select(_e341, _e359, (_e359 < _e341));
let _e367 = global_5.member[bitcast<u32>(select(0i, _e361, (_e361 > 0i)))];
let _e370 = (1f / select(1e-6f, _e367, (_e367 > 1e-6f)));
let _e373 = (((_e349 * _e370) - _e262) * _e257);
let _e376 = (((_e358 * _e370) - _e269) * _e257);
let _e388 = global_1.member.member_5.member;
let _e401 = global_1.member.member_5.member.member_3;
let _e402 = ((((_e388.member * _e310) + (_e388.member_1 * _e319)) + (_e388.member_2 * _e292)) + _e401);
let _e406 = global_1.member.member_5.member_1;
let _e419 = global_1.member.member_5.member_1.member_3;
let _e420 = ((((_e406.member * _e310) + (_e406.member_1 * _e319)) + (_e406.member_2 * _e292)) + _e419);
let _e424 = global_1.member.member_5.member_2;
let _e437 = global_1.member.member_5.member_2.member_3;
let _e438 = ((((_e424.member * _e310) + (_e424.member_1 * _e319)) + (_e424.member_2 * _e292)) + _e437);
let _e444 = ((((_e388.member * _e331) + (_e388.member_1 * _e336)) + (_e388.member_2 * _e325)) + _e401);
let _e450 = ((((_e406.member * _e331) + (_e406.member_1 * _e336)) + (_e406.member_2 * _e325)) + _e419);
let _e456 = ((((_e424.member * _e331) + (_e424.member_1 * _e336)) + (_e424.member_2 * _e325)) + _e437);
let _e461 = global_1.member.member_5.member_3.member_3;
let _e466 = global_1.member.member_5.member_3.member;
let _e467 = (_e466 - 0.5f);
let _e469 = select(-0.5f, _e444, (_e444 > -0.5f));
let _e471 = select(_e467, _e469, (_e469 < _e467));
let _e476 = global_1.member.member_5.member_3.member_1;
let _e477 = (_e476 - 0.5f);
let _e479 = select(-0.5f, _e450, (_e450 > -0.5f));
let _e481 = select(_e477, _e479, (_e479 < _e477));
let _e486 = global_1.member.member_5.member_3.member_2;
let _e487 = (_e486 - 0.5f);
let _e489 = select(-0.5f, _e456, (_e456 > -0.5f));
let _e491 = select(_e487, _e489, (_e489 < _e487));
let _e492 = (_e444 - _e402);
let _e493 = (_e450 - _e420);
let _e494 = (_e456 - _e438);
let _e497 = bitcast<f32>((bitcast<u32>(_e492) & 2147483647u));
let _e500 = bitcast<f32>((bitcast<u32>(_e493) & 2147483647u));
let _e502 = select(_e500, _e497, (_e497 > _e500));
let _e505 = bitcast<f32>((bitcast<u32>(_e494) & 2147483647u));
let _e514 = bitcast<f32>((bitcast<u32>((_e444 - _e471)) & 2147483647u));
let _e517 = bitcast<f32>((bitcast<u32>((_e450 - _e481)) & 2147483647u));
let _e519 = select(_e517, _e514, (_e514 > _e517));
let _e522 = bitcast<f32>((bitcast<u32>((_e456 - _e491)) & 2147483647u));
let _e526 = (_e471 + 0.5f);
let _e527 = (_e466 - 1f);
let _e529 = select(0f, _e526, (_e526 > 0f));
let _e531 = select(_e527, _e529, (_e529 < _e527));
let _e538 = select(0i, select(select(i32(_e531), i32(-2147483648), (_e531 < -2147483600f)), 2147483647i, (_e531 > 2147483500f)), (_e531 == _e531));
let _e547 = global_1.member.member_5.member_7[3u];
let _e548 = (_e547 & 31i);
let _e551 = (_e481 + 0.5f);
let _e552 = (_e476 - 1f);
let _e554 = select(0f, _e551, (_e551 > 0f));
let _e556 = select(_e552, _e554, (_e554 < _e552));
let _e563 = select(0i, select(select(i32(_e556), i32(-2147483648), (_e556 < -2147483600f)), 2147483647i, (_e556 > 2147483500f)), (_e556 == _e556));
let _e570 = (_e491 + 0.5f);
let _e571 = (_e486 - 1f);
let _e573 = select(0f, _e570, (_e570 > 0f));
let _e575 = select(_e571, _e573, (_e573 < _e571));
let _e582 = select(0i, select(select(i32(_e575), i32(-2147483648), (_e575 < -2147483600f)), 2147483647i, (_e575 > 2147483500f)), (_e575 == _e575));
let _e593 = global_1.member.member_5.member_6[3u];
let _e599 = global_1.member.member_5.member_6[0u];
let _e604 = global_1.member.member_5.member_6[1u];
let _e608 = ((_e593 + ((_e538 - select(0i, 1i, (_e531 < f32(_e538)))) >> bitcast<u32>(_e548))) + (_e599 * (((_e563 - select(0i, 1i, (_e556 < f32(_e563)))) >> bitcast<u32>(_e548)) + (_e604 * ((_e582 - select(0i, 1i, (_e575 < f32(_e582)))) >> bitcast<u32>(_e548))))));
let _e610 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e612 = select(_e610, _e608, (_e608 < _e610));
let _e618 = global_3.member[bitcast<u32>(select(0i, _e612, (_e612 > 0i)))];
let _e625 = global_1.member.member[3u];
let _e632 = (((_e625 & 64u) != 0u) || ((((select(_e505, _e502, (_e502 > _e505)) <= _e461) && ((select(_e522, _e519, (_e519 > _e522)) > _e461) || (_e618 != 0u))) && true) && ((_e625 & 32u) != 0u)));
if (select(0u, select(7u, select(3u, 1u, ((((_e264 == 0f) && (_e271 == 0f)) && (_e373 == 0f)) && (_e376 == 0f))), _e632), (_e245 == 0f)) > 1u) {
let _e640 = global_1.member.member[2u];
if _e283 {
break;
}
if _e283 {
break;
}
let _e642 = (_e640 == 2u);
let _e645 = (((_e640 == 1u) || _e642) || (_e640 == 5u));
if _e645 {
let _e1002 = select(-1f, _e471, (_e471 > -1f));
let _e1004 = select(_e466, _e1002, (_e1002 < _e466));
let _e1011 = select(0i, select(select(i32(_e1004), i32(-2147483648), (_e1004 < -2147483600f)), 2147483647i, (_e1004 > 2147483500f)), (_e1004 == _e1004));
let _e1015 = (_e1011 - select(0i, 1i, (_e1004 < f32(_e1011))));
let _e1017 = select(-1f, _e481, (_e481 > -1f));
let _e1019 = select(_e476, _e1017, (_e1017 < _e476));
let _e1026 = select(0i, select(select(i32(_e1019), i32(-2147483648), (_e1019 < -2147483600f)), 2147483647i, (_e1019 > 2147483500f)), (_e1019 == _e1019));
let _e1030 = (_e1026 - select(0i, 1i, (_e1019 < f32(_e1026))));
let _e1032 = select(-1f, _e491, (_e491 > -1f));
let _e1034 = select(_e486, _e1032, (_e1032 < _e486));
let _e1041 = select(0i, select(select(i32(_e1034), i32(-2147483648), (_e1034 < -2147483600f)), 2147483647i, (_e1034 > 2147483500f)), (_e1034 == _e1034));
let _e1045 = (_e1041 - select(0i, 1i, (_e1034 < f32(_e1041))));
let _e1050 = global_1.member.member_5.member_5[0u];
let _e1055 = global_1.member.member_5.member_5[1u];
let _e1056 = (_e1015 + 1i);
let _e1057 = (_e1030 + 1i);
let _e1058 = (_e1045 + 1i);
let _e1065 = global_1.member.member_5.member_7[0u];
let _e1072 = global_1.member.member_5.member_7[1u];
let _e1078 = ((_e1056 >> bitcast<u32>(4i)) + (_e1065 * ((_e1057 >> bitcast<u32>(4i)) + (_e1072 * (_e1058 >> bitcast<u32>(4i))))));
let _e1080 = (bitcast<i32>(_e93) - 1i);
let _e1082 = select(_e1080, _e1078, (_e1078 < _e1080));
let _e1088 = global_2.member[bitcast<u32>(select(0i, _e1082, (_e1082 > 0i)))];
let _e1090 = (_e1056 & 15i);
let _e1093 = ((_e1057 & 15i) * _e1050);
let _e1095 = (bitcast<i32>(_e1088) + ((_e1058 & 15i) * _e1055));
let _e1099 = (_e1093 + _e1050);
let _e1101 = (_e1093 + (2i * _e1050));
let _e1103 = (_e1093 + (3i * _e1050));
let _e1104 = (_e1095 + _e1055);
let _e1106 = (_e1095 + (2i * _e1055));
let _e1108 = (_e1095 + (3i * _e1055));
local_4 = type_18(array<i32, 4>(_e1090, (_e1090 + 1i), (_e1090 + 2i), (_e1090 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_5 = vec3<f32>((_e471 - f32(_e1015)), (_e481 - f32(_e1030)), (_e491 - f32(_e1045)));
let _e1119 = (_e1104 + _e1099);
let _e1122 = local_4.member[0u];
let _e1123 = (_e1119 + _e1122);
let _e1125 = (_e1123 >> bitcast<u32>(1i));
let _e1128 = bitcast<u32>(((_e1123 & 1i) * 16i));
let _e1130 = select(_e1080, _e1125, (_e1125 < _e1080));
let _e1135 = global_2.member[bitcast<u32>(select(0i, _e1130, (_e1130 > 0i)))];
let _e1139 = (_e1125 + 1i);
let _e1141 = select(_e1080, _e1139, (_e1139 < _e1080));
let _e1146 = global_2.member[bitcast<u32>(select(0i, _e1141, (_e1141 > 0i)))];
let _e1153 = ((_e1135 >> bitcast<u32>((_e1128 & 31u))) | ((_e1146 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1128) & 31u))));
let _e1156 = local_4.member[2u];
let _e1157 = (_e1119 + _e1156);
let _e1159 = (_e1157 >> bitcast<u32>(1i));
let _e1162 = bitcast<u32>(((_e1157 & 1i) * 16i));
let _e1164 = select(_e1080, _e1159, (_e1159 < _e1080));
let _e1169 = global_2.member[bitcast<u32>(select(0i, _e1164, (_e1164 > 0i)))];
let _e1173 = (_e1159 + 1i);
let _e1175 = select(_e1080, _e1173, (_e1173 < _e1080));
let _e1180 = global_2.member[bitcast<u32>(select(0i, _e1175, (_e1175 > 0i)))];
let _e1187 = ((_e1169 >> bitcast<u32>((_e1162 & 31u))) | ((_e1180 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1162) & 31u))));
let _e1190 = local_4.member_1[0u];
let _e1196 = f32(bitcast<i32>(((_e1153 >> bitcast<u32>((_e1190 & 31u))) & 65535u)));
let _e1199 = local_4.member_1[1u];
let _e1205 = f32(bitcast<i32>(((_e1153 >> bitcast<u32>((_e1199 & 31u))) & 65535u)));
let _e1208 = local_4.member_1[4u];
let _e1214 = f32(bitcast<i32>(((_e1187 >> bitcast<u32>((_e1208 & 31u))) & 65535u)));
let _e1217 = local_4.member_1[5u];
let _e1224 = local_5[0u];
let _e1227 = (_e1196 + ((_e1205 - _e1196) * _e1224));
let _e1228 = local_5[0u];
let _e1231 = (_e1205 + ((_e1214 - _e1205) * _e1228));
let _e1232 = local_5[0u];
let _e1235 = (_e1214 + ((f32(bitcast<i32>(((_e1187 >> bitcast<u32>((_e1217 & 31u))) & 65535u))) - _e1214) * _e1232));
let _e1236 = (_e1104 + _e1101);
let _e1237 = local_4.member[0u];
let _e1238 = (_e1236 + _e1237);
let _e1240 = (_e1238 >> bitcast<u32>(1i));
let _e1243 = bitcast<u32>(((_e1238 & 1i) * 16i));
let _e1245 = select(_e1080, _e1240, (_e1240 < _e1080));
let _e1250 = global_2.member[bitcast<u32>(select(0i, _e1245, (_e1245 > 0i)))];
let _e1254 = (_e1240 + 1i);
let _e1256 = select(_e1080, _e1254, (_e1254 < _e1080));
let _e1261 = global_2.member[bitcast<u32>(select(0i, _e1256, (_e1256 > 0i)))];
let _e1268 = ((_e1250 >> bitcast<u32>((_e1243 & 31u))) | ((_e1261 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1243) & 31u))));
let _e1269 = local_4.member[2u];
let _e1270 = (_e1236 + _e1269);
let _e1272 = (_e1270 >> bitcast<u32>(1i));
let _e1275 = bitcast<u32>(((_e1270 & 1i) * 16i));
let _e1277 = select(_e1080, _e1272, (_e1272 < _e1080));
let _e1282 = global_2.member[bitcast<u32>(select(0i, _e1277, (_e1277 > 0i)))];
let _e1286 = (_e1272 + 1i);
let _e1288 = select(_e1080, _e1286, (_e1286 < _e1080));
let _e1293 = global_2.member[bitcast<u32>(select(0i, _e1288, (_e1288 > 0i)))];
let _e1300 = ((_e1282 >> bitcast<u32>((_e1275 & 31u))) | ((_e1293 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1275) & 31u))));
let _e1301 = local_4.member_1[0u];
let _e1307 = f32(bitcast<i32>(((_e1268 >> bitcast<u32>((_e1301 & 31u))) & 65535u)));
let _e1308 = local_4.member_1[1u];
let _e1314 = f32(bitcast<i32>(((_e1268 >> bitcast<u32>((_e1308 & 31u))) & 65535u)));
let _e1315 = local_4.member_1[4u];
let _e1321 = f32(bitcast<i32>(((_e1300 >> bitcast<u32>((_e1315 & 31u))) & 65535u)));
let _e1322 = local_4.member_1[5u];
let _e1329 = local_5[0u];
let _e1333 = local_5[0u];
let _e1336 = (_e1314 + ((_e1321 - _e1314) * _e1333));
let _e1337 = local_5[0u];
let _e1341 = (_e1106 + _e1099);
let _e1342 = local_4.member[0u];
let _e1343 = (_e1341 + _e1342);
let _e1345 = (_e1343 >> bitcast<u32>(1i));
let _e1348 = bitcast<u32>(((_e1343 & 1i) * 16i));
let _e1350 = select(_e1080, _e1345, (_e1345 < _e1080));
let _e1355 = global_2.member[bitcast<u32>(select(0i, _e1350, (_e1350 > 0i)))];
let _e1359 = (_e1345 + 1i);
let _e1361 = select(_e1080, _e1359, (_e1359 < _e1080));
let _e1366 = global_2.member[bitcast<u32>(select(0i, _e1361, (_e1361 > 0i)))];
let _e1373 = ((_e1355 >> bitcast<u32>((_e1348 & 31u))) | ((_e1366 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1348) & 31u))));
let _e1374 = local_4.member[2u];
let _e1375 = (_e1341 + _e1374);
let _e1377 = (_e1375 >> bitcast<u32>(1i));
let _e1380 = bitcast<u32>(((_e1375 & 1i) * 16i));
let _e1382 = select(_e1080, _e1377, (_e1377 < _e1080));
let _e1387 = global_2.member[bitcast<u32>(select(0i, _e1382, (_e1382 > 0i)))];
let _e1391 = (_e1377 + 1i);
let _e1393 = select(_e1080, _e1391, (_e1391 < _e1080));
let _e1398 = global_2.member[bitcast<u32>(select(0i, _e1393, (_e1393 > 0i)))];
let _e1405 = ((_e1387 >> bitcast<u32>((_e1380 & 31u))) | ((_e1398 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1380) & 31u))));
let _e1406 = local_4.member_1[0u];
let _e1412 = f32(bitcast<i32>(((_e1373 >> bitcast<u32>((_e1406 & 31u))) & 65535u)));
let _e1413 = local_4.member_1[1u];
let _e1419 = f32(bitcast<i32>(((_e1373 >> bitcast<u32>((_e1413 & 31u))) & 65535u)));
let _e1420 = local_4.member_1[4u];
let _e1426 = f32(bitcast<i32>(((_e1405 >> bitcast<u32>((_e1420 & 31u))) & 65535u)));
let _e1427 = local_4.member_1[5u];
let _e1434 = local_5[0u];
let _e1437 = (_e1412 + ((_e1419 - _e1412) * _e1434));
let _e1438 = local_5[0u];
let _e1441 = (_e1419 + ((_e1426 - _e1419) * _e1438));
let _e1442 = local_5[0u];
let _e1445 = (_e1426 + ((f32(bitcast<i32>(((_e1405 >> bitcast<u32>((_e1427 & 31u))) & 65535u))) - _e1426) * _e1442));
let _e1446 = (_e1106 + _e1101);
let _e1447 = local_4.member[0u];
let _e1448 = (_e1446 + _e1447);
let _e1450 = (_e1448 >> bitcast<u32>(1i));
let _e1453 = bitcast<u32>(((_e1448 & 1i) * 16i));
let _e1455 = select(_e1080, _e1450, (_e1450 < _e1080));
let _e1460 = global_2.member[bitcast<u32>(select(0i, _e1455, (_e1455 > 0i)))];
let _e1464 = (_e1450 + 1i);
let _e1466 = select(_e1080, _e1464, (_e1464 < _e1080));
let _e1471 = global_2.member[bitcast<u32>(select(0i, _e1466, (_e1466 > 0i)))];
let _e1478 = ((_e1460 >> bitcast<u32>((_e1453 & 31u))) | ((_e1471 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1453) & 31u))));
let _e1479 = local_4.member[2u];
let _e1480 = (_e1446 + _e1479);
let _e1482 = (_e1480 >> bitcast<u32>(1i));
let _e1485 = bitcast<u32>(((_e1480 & 1i) * 16i));
let _e1487 = select(_e1080, _e1482, (_e1482 < _e1080));
let _e1492 = global_2.member[bitcast<u32>(select(0i, _e1487, (_e1487 > 0i)))];
let _e1496 = (_e1482 + 1i);
let _e1498 = select(_e1080, _e1496, (_e1496 < _e1080));
let _e1503 = global_2.member[bitcast<u32>(select(0i, _e1498, (_e1498 > 0i)))];
let _e1510 = ((_e1492 >> bitcast<u32>((_e1485 & 31u))) | ((_e1503 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1485) & 31u))));
let _e1511 = local_4.member_1[0u];
let _e1517 = f32(bitcast<i32>(((_e1478 >> bitcast<u32>((_e1511 & 31u))) & 65535u)));
let _e1518 = local_4.member_1[1u];
let _e1524 = f32(bitcast<i32>(((_e1478 >> bitcast<u32>((_e1518 & 31u))) & 65535u)));
let _e1525 = local_4.member_1[4u];
let _e1531 = f32(bitcast<i32>(((_e1510 >> bitcast<u32>((_e1525 & 31u))) & 65535u)));
let _e1532 = local_4.member_1[5u];
let _e1539 = local_5[0u];
let _e1543 = local_5[0u];
let _e1546 = (_e1524 + ((_e1531 - _e1524) * _e1543));
let _e1547 = local_5[0u];
let _e1554 = local_4.member[1u];
let _e1555 = ((_e1104 + _e1093) + _e1554);
let _e1557 = (_e1555 >> bitcast<u32>(1i));
let _e1560 = bitcast<u32>(((_e1555 & 1i) * 16i));
let _e1562 = select(_e1080, _e1557, (_e1557 < _e1080));
let _e1567 = global_2.member[bitcast<u32>(select(0i, _e1562, (_e1562 > 0i)))];
let _e1571 = (_e1557 + 1i);
let _e1573 = select(_e1080, _e1571, (_e1571 < _e1080));
let _e1578 = global_2.member[bitcast<u32>(select(0i, _e1573, (_e1573 > 0i)))];
let _e1585 = ((_e1567 >> bitcast<u32>((_e1560 & 31u))) | ((_e1578 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1560) & 31u))));
let _e1588 = local_4.member_1[2u];
let _e1594 = f32(bitcast<i32>(((_e1585 >> bitcast<u32>((_e1588 & 31u))) & 65535u)));
let _e1597 = local_4.member_1[3u];
let _e1604 = local_5[0u];
let _e1607 = (_e1594 + ((f32(bitcast<i32>(((_e1585 >> bitcast<u32>((_e1597 & 31u))) & 65535u))) - _e1594) * _e1604));
let _e1609 = local_4.member[1u];
let _e1610 = ((_e1104 + _e1103) + _e1609);
let _e1612 = (_e1610 >> bitcast<u32>(1i));
let _e1615 = bitcast<u32>(((_e1610 & 1i) * 16i));
let _e1617 = select(_e1080, _e1612, (_e1612 < _e1080));
let _e1622 = global_2.member[bitcast<u32>(select(0i, _e1617, (_e1617 > 0i)))];
let _e1626 = (_e1612 + 1i);
let _e1628 = select(_e1080, _e1626, (_e1626 < _e1080));
let _e1633 = global_2.member[bitcast<u32>(select(0i, _e1628, (_e1628 > 0i)))];
let _e1640 = ((_e1622 >> bitcast<u32>((_e1615 & 31u))) | ((_e1633 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1615) & 31u))));
let _e1641 = local_4.member_1[2u];
let _e1647 = f32(bitcast<i32>(((_e1640 >> bitcast<u32>((_e1641 & 31u))) & 65535u)));
let _e1648 = local_4.member_1[3u];
let _e1655 = local_5[0u];
let _e1660 = local_4.member[1u];
let _e1661 = ((_e1106 + _e1093) + _e1660);
let _e1663 = (_e1661 >> bitcast<u32>(1i));
let _e1666 = bitcast<u32>(((_e1661 & 1i) * 16i));
let _e1668 = select(_e1080, _e1663, (_e1663 < _e1080));
let _e1673 = global_2.member[bitcast<u32>(select(0i, _e1668, (_e1668 > 0i)))];
let _e1677 = (_e1663 + 1i);
let _e1679 = select(_e1080, _e1677, (_e1677 < _e1080));
let _e1684 = global_2.member[bitcast<u32>(select(0i, _e1679, (_e1679 > 0i)))];
let _e1691 = ((_e1673 >> bitcast<u32>((_e1666 & 31u))) | ((_e1684 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1666) & 31u))));
let _e1692 = local_4.member_1[2u];
let _e1698 = f32(bitcast<i32>(((_e1691 >> bitcast<u32>((_e1692 & 31u))) & 65535u)));
let _e1699 = local_4.member_1[3u];
let _e1706 = local_5[0u];
let _e1709 = (_e1698 + ((f32(bitcast<i32>(((_e1691 >> bitcast<u32>((_e1699 & 31u))) & 65535u))) - _e1698) * _e1706));
let _e1711 = local_4.member[1u];
let _e1712 = ((_e1106 + _e1103) + _e1711);
let _e1714 = (_e1712 >> bitcast<u32>(1i));
let _e1717 = bitcast<u32>(((_e1712 & 1i) * 16i));
let _e1719 = select(_e1080, _e1714, (_e1714 < _e1080));
let _e1724 = global_2.member[bitcast<u32>(select(0i, _e1719, (_e1719 > 0i)))];
let _e1728 = (_e1714 + 1i);
let _e1730 = select(_e1080, _e1728, (_e1728 < _e1080));
let _e1735 = global_2.member[bitcast<u32>(select(0i, _e1730, (_e1730 > 0i)))];
let _e1742 = ((_e1724 >> bitcast<u32>((_e1717 & 31u))) | ((_e1735 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1717) & 31u))));
let _e1743 = local_4.member_1[2u];
let _e1749 = f32(bitcast<i32>(((_e1742 >> bitcast<u32>((_e1743 & 31u))) & 65535u)));
let _e1750 = local_4.member_1[3u];
let _e1757 = local_5[0u];
let _e1762 = local_4.member[1u];
let _e1763 = ((_e1095 + _e1099) + _e1762);
let _e1765 = (_e1763 >> bitcast<u32>(1i));
let _e1768 = bitcast<u32>(((_e1763 & 1i) * 16i));
let _e1770 = select(_e1080, _e1765, (_e1765 < _e1080));
let _e1775 = global_2.member[bitcast<u32>(select(0i, _e1770, (_e1770 > 0i)))];
let _e1779 = (_e1765 + 1i);
let _e1781 = select(_e1080, _e1779, (_e1779 < _e1080));
let _e1786 = global_2.member[bitcast<u32>(select(0i, _e1781, (_e1781 > 0i)))];
let _e1793 = ((_e1775 >> bitcast<u32>((_e1768 & 31u))) | ((_e1786 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1768) & 31u))));
let _e1794 = local_4.member_1[2u];
let _e1800 = f32(bitcast<i32>(((_e1793 >> bitcast<u32>((_e1794 & 31u))) & 65535u)));
let _e1801 = local_4.member_1[3u];
let _e1808 = local_5[0u];
let _e1811 = (_e1800 + ((f32(bitcast<i32>(((_e1793 >> bitcast<u32>((_e1801 & 31u))) & 65535u))) - _e1800) * _e1808));
let _e1813 = local_4.member[1u];
let _e1814 = ((_e1108 + _e1099) + _e1813);
let _e1816 = (_e1814 >> bitcast<u32>(1i));
let _e1819 = bitcast<u32>(((_e1814 & 1i) * 16i));
let _e1821 = select(_e1080, _e1816, (_e1816 < _e1080));
let _e1826 = global_2.member[bitcast<u32>(select(0i, _e1821, (_e1821 > 0i)))];
let _e1830 = (_e1816 + 1i);
let _e1832 = select(_e1080, _e1830, (_e1830 < _e1080));
let _e1837 = global_2.member[bitcast<u32>(select(0i, _e1832, (_e1832 > 0i)))];
let _e1844 = ((_e1826 >> bitcast<u32>((_e1819 & 31u))) | ((_e1837 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1819) & 31u))));
let _e1845 = local_4.member_1[2u];
let _e1851 = f32(bitcast<i32>(((_e1844 >> bitcast<u32>((_e1845 & 31u))) & 65535u)));
let _e1852 = local_4.member_1[3u];
let _e1859 = local_5[0u];
let _e1862 = (_e1851 + ((f32(bitcast<i32>(((_e1844 >> bitcast<u32>((_e1852 & 31u))) & 65535u))) - _e1851) * _e1859));
let _e1864 = local_4.member[1u];
let _e1865 = ((_e1095 + _e1101) + _e1864);
let _e1867 = (_e1865 >> bitcast<u32>(1i));
let _e1870 = bitcast<u32>(((_e1865 & 1i) * 16i));
let _e1872 = select(_e1080, _e1867, (_e1867 < _e1080));
let _e1877 = global_2.member[bitcast<u32>(select(0i, _e1872, (_e1872 > 0i)))];
let _e1881 = (_e1867 + 1i);
let _e1883 = select(_e1080, _e1881, (_e1881 < _e1080));
let _e1888 = global_2.member[bitcast<u32>(select(0i, _e1883, (_e1883 > 0i)))];
let _e1895 = ((_e1877 >> bitcast<u32>((_e1870 & 31u))) | ((_e1888 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1870) & 31u))));
let _e1896 = local_4.member_1[2u];
let _e1902 = f32(bitcast<i32>(((_e1895 >> bitcast<u32>((_e1896 & 31u))) & 65535u)));
let _e1903 = local_4.member_1[3u];
let _e1910 = local_5[0u];
let _e1915 = local_4.member[1u];
let _e1916 = ((_e1108 + _e1101) + _e1915);
let _e1918 = (_e1916 >> bitcast<u32>(1i));
let _e1921 = bitcast<u32>(((_e1916 & 1i) * 16i));
let _e1923 = select(_e1080, _e1918, (_e1918 < _e1080));
let _e1928 = global_2.member[bitcast<u32>(select(0i, _e1923, (_e1923 > 0i)))];
let _e1932 = (_e1918 + 1i);
let _e1934 = select(_e1080, _e1932, (_e1932 < _e1080));
let _e1939 = global_2.member[bitcast<u32>(select(0i, _e1934, (_e1934 > 0i)))];
let _e1946 = ((_e1928 >> bitcast<u32>((_e1921 & 31u))) | ((_e1939 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1921) & 31u))));
let _e1947 = local_4.member_1[2u];
let _e1953 = f32(bitcast<i32>(((_e1946 >> bitcast<u32>((_e1947 & 31u))) & 65535u)));
let _e1954 = local_4.member_1[3u];
let _e1961 = local_5[0u];
let _e1966 = local_5[1u];
let _e1969 = (_e1231 + ((_e1336 - _e1231) * _e1966));
let _e1970 = local_5[1u];
let _e1973 = (_e1441 + ((_e1546 - _e1441) * _e1970));
let _e1974 = local_5[1u];
let _e1977 = (_e1227 + (((_e1307 + ((_e1314 - _e1307) * _e1329)) - _e1227) * _e1974));
let _e1978 = local_5[1u];
let _e1983 = local_5[2u];
let _e1987 = local_5[1u];
let _e1990 = (_e1235 + (((_e1321 + ((f32(bitcast<i32>(((_e1300 >> bitcast<u32>((_e1322 & 31u))) & 65535u))) - _e1321) * _e1337)) - _e1235) * _e1987));
let _e1991 = local_5[1u];
let _e1995 = local_5[2u];
let _e1999 = local_5[1u];
let _e2002 = (_e1607 + ((_e1231 - _e1607) * _e1999));
let _e2003 = local_5[1u];
let _e2007 = local_5[2u];
let _e2011 = local_5[1u];
let _e2014 = (_e1336 + (((_e1647 + ((f32(bitcast<i32>(((_e1640 >> bitcast<u32>((_e1648 & 31u))) & 65535u))) - _e1647) * _e1655)) - _e1336) * _e2011));
let _e2015 = local_5[1u];
let _e2019 = local_5[2u];
let _e2023 = local_5[1u];
let _e2026 = (_e1811 + (((_e1902 + ((f32(bitcast<i32>(((_e1895 >> bitcast<u32>((_e1903 & 31u))) & 65535u))) - _e1902) * _e1910)) - _e1811) * _e2023));
let _e2027 = local_5[2u];
let _e2031 = local_5[1u];
let _e2035 = local_5[2u];
let _e2039 = local_5[2u];
let _e2047 = global_1.member.member_5.member_4.member;
let _e2053 = global_1.member.member_5.member_4.member_1;
let _e2054 = (((_e1969 + ((_e1973 - _e1969) * _e2039)) * _e2047) + _e2053);
let _e2056 = select(0f, _e2054, (_e2054 > 0f));
let _e2058 = select(1f, _e2056, (_e2056 < 1f));
let _e2060 = (((_e1977 + (((_e1437 + (((_e1517 + ((_e1524 - _e1517) * _e1539)) - _e1437) * _e1978)) - _e1977) * _e1983)) * _e2047) + _e2053);
let _e2062 = select(0f, _e2060, (_e2060 > 0f));
let _e2064 = select(1f, _e2062, (_e2062 < 1f));
let _e2066 = (((_e1990 + (((_e1445 + (((_e1531 + ((f32(bitcast<i32>(((_e1510 >> bitcast<u32>((_e1532 & 31u))) & 65535u))) - _e1531) * _e1547)) - _e1445) * _e1991)) - _e1990) * _e1995)) * _e2047) + _e2053);
let _e2068 = select(0f, _e2066, (_e2066 > 0f));
let _e2070 = select(1f, _e2068, (_e2068 < 1f));
let _e2072 = (((_e2002 + (((_e1709 + ((_e1441 - _e1709) * _e2003)) - _e2002) * _e2007)) * _e2047) + _e2053);
let _e2074 = select(0f, _e2072, (_e2072 > 0f));
let _e2076 = select(1f, _e2074, (_e2074 < 1f));
let _e2078 = (((_e2014 + (((_e1546 + (((_e1749 + ((f32(bitcast<i32>(((_e1742 >> bitcast<u32>((_e1750 & 31u))) & 65535u))) - _e1749) * _e1757)) - _e1546) * _e2015)) - _e2014) * _e2019)) * _e2047) + _e2053);
let _e2080 = select(0f, _e2078, (_e2078 > 0f));
let _e2082 = select(1f, _e2080, (_e2080 < 1f));
let _e2084 = (((_e2026 + ((_e1969 - _e2026) * _e2027)) * _e2047) + _e2053);
let _e2086 = select(0f, _e2084, (_e2084 > 0f));
let _e2088 = select(1f, _e2086, (_e2086 < 1f));
let _e2090 = (((_e1973 + (((_e1862 + (((_e1953 + ((f32(bitcast<i32>(((_e1946 >> bitcast<u32>((_e1954 & 31u))) & 65535u))) - _e1953) * _e1961)) - _e1862) * _e2031)) - _e1973) * _e2035)) * _e2047) + _e2053);
let _e2092 = select(0f, _e2090, (_e2090 > 0f));
let _e2094 = select(1f, _e2092, (_e2092 < 1f));
let _e2095 = (_e2058 * 1024f);
let _e2096 = (1024f - 1f);
let _e2098 = select(0f, _e2095, (_e2095 > 0f));
let _e2100 = select(_e2096, _e2098, (_e2098 < _e2096));
let _e2107 = select(0i, select(select(i32(_e2100), i32(-2147483648), (_e2100 < -2147483600f)), 2147483647i, (_e2100 > 2147483500f)), (_e2100 == _e2100));
let _e2111 = (_e2107 - select(0i, 1i, (_e2100 < f32(_e2107))));
let _e2112 = (262147i + _e2111);
let _e2114 = (bitcast<i32>(_e97) - 1i);
let _e2116 = select(_e2114, _e2112, (_e2112 < _e2114));
let _e2122 = global_4.member[bitcast<u32>(select(0i, _e2116, (_e2116 > 0i)))];
let _e2132 = select(_e2114, 262146i, (262146i < _e2114));
let _e2138 = global_4.member[bitcast<u32>(select(0i, _e2132, (_e2132 > 0i)))];
let _e2139 = bitcast<f32>(_e2138);
let _e2140 = (f32((bitcast<i32>((_e2122 & 4095u)) - 2048i)) * _e2139);
let _e2142 = select(_e2114, 262144i, (262144i < _e2114));
let _e2148 = global_4.member[bitcast<u32>(select(0i, _e2142, (_e2142 > 0i)))];
let _e2149 = bitcast<f32>(_e2148);
let _e2151 = select(_e2114, 262145i, (262145i < _e2114));
let _e2157 = global_4.member[bitcast<u32>(select(0i, _e2151, (_e2151 > 0i)))];
let _e2158 = bitcast<f32>(_e2157);
let _e2164 = ((_e2149 + (f32(bitcast<i32>((_e2122 >> bitcast<u32>(12u)))) * _e2158)) + (_e2140 * (_e2095 - f32(_e2111))));
let _e2165 = (_e2140 * 1024f);
if _e642 {
let _e2430 = ((0.5f * (_e2070 - _e2064)) * _e2165);
let _e2431 = ((0.5f * (_e2082 - _e2076)) * _e2165);
let _e2432 = ((0.5f * (_e2094 - _e2088)) * _e2165);
phi_5835_ = type_19(_e2164, vec3<f32>(_e2430, _e2431, _e2432), vec3<f32>((_e2430 * _e2164), (_e2431 * _e2164), (_e2432 * _e2164)));
} else {
let _e2166 = (_e2064 * 1024f);
let _e2168 = select(0f, _e2166, (_e2166 > 0f));
let _e2170 = select(_e2096, _e2168, (_e2168 < _e2096));
let _e2177 = select(0i, select(select(i32(_e2170), i32(-2147483648), (_e2170 < -2147483600f)), 2147483647i, (_e2170 > 2147483500f)), (_e2170 == _e2170));
let _e2181 = (_e2177 - select(0i, 1i, (_e2170 < f32(_e2177))));
let _e2182 = (262147i + _e2181);
let _e2184 = select(_e2114, _e2182, (_e2182 < _e2114));
let _e2190 = global_4.member[bitcast<u32>(select(0i, _e2184, (_e2184 > 0i)))];
let _e2205 = ((_e2149 + (f32(bitcast<i32>((_e2190 >> bitcast<u32>(12u)))) * _e2158)) + ((f32((bitcast<i32>((_e2190 & 4095u)) - 2048i)) * _e2139) * (_e2166 - f32(_e2181))));
let _e2206 = (_e2070 * 1024f);
let _e2208 = select(0f, _e2206, (_e2206 > 0f));
let _e2210 = select(_e2096, _e2208, (_e2208 < _e2096));
let _e2217 = select(0i, select(select(i32(_e2210), i32(-2147483648), (_e2210 < -2147483600f)), 2147483647i, (_e2210 > 2147483500f)), (_e2210 == _e2210));
let _e2221 = (_e2217 - select(0i, 1i, (_e2210 < f32(_e2217))));
let _e2222 = (262147i + _e2221);
let _e2224 = select(_e2114, _e2222, (_e2222 < _e2114));
let _e2230 = global_4.member[bitcast<u32>(select(0i, _e2224, (_e2224 > 0i)))];
let _e2245 = ((_e2149 + (f32(bitcast<i32>((_e2230 >> bitcast<u32>(12u)))) * _e2158)) + ((f32((bitcast<i32>((_e2230 & 4095u)) - 2048i)) * _e2139) * (_e2206 - f32(_e2221))));
let _e2246 = (_e2076 * 1024f);
let _e2248 = select(0f, _e2246, (_e2246 > 0f));
let _e2250 = select(_e2096, _e2248, (_e2248 < _e2096));
let _e2257 = select(0i, select(select(i32(_e2250), i32(-2147483648), (_e2250 < -2147483600f)), 2147483647i, (_e2250 > 2147483500f)), (_e2250 == _e2250));
let _e2261 = (_e2257 - select(0i, 1i, (_e2250 < f32(_e2257))));
let _e2262 = (262147i + _e2261);
let _e2264 = select(_e2114, _e2262, (_e2262 < _e2114));
let _e2270 = global_4.member[bitcast<u32>(select(0i, _e2264, (_e2264 > 0i)))];
let _e2285 = ((_e2149 + (f32(bitcast<i32>((_e2270 >> bitcast<u32>(12u)))) * _e2158)) + ((f32((bitcast<i32>((_e2270 & 4095u)) - 2048i)) * _e2139) * (_e2246 - f32(_e2261))));
let _e2286 = (_e2082 * 1024f);
let _e2288 = select(0f, _e2286, (_e2286 > 0f));
let _e2290 = select(_e2096, _e2288, (_e2288 < _e2096));
let _e2297 = select(0i, select(select(i32(_e2290), i32(-2147483648), (_e2290 < -2147483600f)), 2147483647i, (_e2290 > 2147483500f)), (_e2290 == _e2290));
let _e2301 = (_e2297 - select(0i, 1i, (_e2290 < f32(_e2297))));
let _e2302 = (262147i + _e2301);
let _e2304 = select(_e2114, _e2302, (_e2302 < _e2114));
let _e2310 = global_4.member[bitcast<u32>(select(0i, _e2304, (_e2304 > 0i)))];
let _e2325 = ((_e2149 + (f32(bitcast<i32>((_e2310 >> bitcast<u32>(12u)))) * _e2158)) + ((f32((bitcast<i32>((_e2310 & 4095u)) - 2048i)) * _e2139) * (_e2286 - f32(_e2301))));
let _e2326 = (_e2088 * 1024f);
let _e2328 = select(0f, _e2326, (_e2326 > 0f));
let _e2330 = select(_e2096, _e2328, (_e2328 < _e2096));
let _e2337 = select(0i, select(select(i32(_e2330), i32(-2147483648), (_e2330 < -2147483600f)), 2147483647i, (_e2330 > 2147483500f)), (_e2330 == _e2330));
let _e2341 = (_e2337 - select(0i, 1i, (_e2330 < f32(_e2337))));
let _e2342 = (262147i + _e2341);
let _e2344 = select(_e2114, _e2342, (_e2342 < _e2114));
let _e2350 = global_4.member[bitcast<u32>(select(0i, _e2344, (_e2344 > 0i)))];
let _e2365 = ((_e2149 + (f32(bitcast<i32>((_e2350 >> bitcast<u32>(12u)))) * _e2158)) + ((f32((bitcast<i32>((_e2350 & 4095u)) - 2048i)) * _e2139) * (_e2326 - f32(_e2341))));
let _e2366 = (_e2094 * 1024f);
let _e2368 = select(0f, _e2366, (_e2366 > 0f));
let _e2370 = select(_e2096, _e2368, (_e2368 < _e2096));
let _e2377 = select(0i, select(select(i32(_e2370), i32(-2147483648), (_e2370 < -2147483600f)), 2147483647i, (_e2370 > 2147483500f)), (_e2370 == _e2370));
let _e2381 = (_e2377 - select(0i, 1i, (_e2370 < f32(_e2377))));
let _e2382 = (262147i + _e2381);
let _e2384 = select(_e2114, _e2382, (_e2382 < _e2114));
let _e2390 = global_4.member[bitcast<u32>(select(0i, _e2384, (_e2384 > 0i)))];
let _e2405 = ((_e2149 + (f32(bitcast<i32>((_e2390 >> bitcast<u32>(12u)))) * _e2158)) + ((f32((bitcast<i32>((_e2390 & 4095u)) - 2048i)) * _e2139) * (_e2366 - f32(_e2381))));
let _e2406 = (_e2245 - _e2205);
let _e2408 = (_e2325 - _e2285);
let _e2410 = (_e2405 - _e2365);
phi_5835_ = type_19(_e2164, vec3<f32>((0.5f * _e2406), (0.5f * _e2408), (0.5f * _e2410)), vec3<f32>((0.25f * (_e2406 * (_e2245 + _e2205))), (0.25f * (_e2408 * (_e2325 + _e2285))), (0.25f * (_e2410 * (_e2405 + _e2365)))));
}
let _e2440 = phi_5835_;
let _e2455 = select(0f, 1f, ((((((_e444 >= -0.5f) && (_e444 <= _e467)) && (_e450 >= -0.5f)) && (_e450 <= _e477)) && (_e456 >= -0.5f)) && (_e456 <= _e487)));
let _e2457 = (0.5f * (_e2070 - _e2064));
let _e2459 = (0.5f * (_e2082 - _e2076));
let _e2461 = (0.5f * (_e2094 - _e2088));
let _e2466 = global_1.member.member_5.member.member;
let _e2472 = global_1.member.member_5.member_1.member;
let _e2479 = global_1.member.member_5.member_2.member;
let _e2486 = global_1.member.member_5.member.member_1;
let _e2492 = global_1.member.member_5.member_1.member_1;
let _e2499 = global_1.member.member_5.member_2.member_1;
let _e2506 = global_1.member.member_5.member.member_2;
let _e2512 = global_1.member.member_5.member_1.member_2;
let _e2519 = global_1.member.member_5.member_2.member_2;
phi_7155_ = type_20(_e2058, vec3<f32>(((((_e2466 * _e2457) + (_e2472 * _e2459)) + (_e2479 * _e2461)) * _e2455), ((((_e2486 * _e2457) + (_e2492 * _e2459)) + (_e2499 * _e2461)) * _e2455), ((((_e2506 * _e2457) + (_e2512 * _e2459)) + (_e2519 * _e2461)) * _e2455)), _e2440.member, vec3<f32>(((((_e2466 * _e2440.member_2.x) + (_e2472 * _e2440.member_2.y)) + (_e2479 * _e2440.member_2.z)) * _e2455), ((((_e2486 * _e2440.member_2.x) + (_e2492 * _e2440.member_2.y)) + (_e2499 * _e2440.member_2.z)) * _e2455), ((((_e2506 * _e2440.member_2.x) + (_e2512 * _e2440.member_2.y)) + (_e2519 * _e2440.member_2.z)) * _e2455)), vec3<f32>(((((_e2466 * _e2440.member_1.x) + (_e2472 * _e2440.member_1.y)) + (_e2479 * _e2440.member_1.z)) * _e2455), ((((_e2486 * _e2440.member_1.x) + (_e2492 * _e2440.member_1.y)) + (_e2499 * _e2440.member_1.z)) * _e2455), ((((_e2506 * _e2440.member_1.x) + (_e2512 * _e2440.member_1.y)) + (_e2519 * _e2440.member_1.z)) * _e2455)));
} else {
let _e647 = select(-1f, _e471, (_e471 > -1f));
let _e649 = select(_e466, _e647, (_e647 < _e466));
let _e656 = select(0i, select(select(i32(_e649), i32(-2147483648), (_e649 < -2147483600f)), 2147483647i, (_e649 > 2147483500f)), (_e649 == _e649));
let _e660 = (_e656 - select(0i, 1i, (_e649 < f32(_e656))));
let _e662 = select(-1f, _e481, (_e481 > -1f));
let _e664 = select(_e476, _e662, (_e662 < _e476));
let _e671 = select(0i, select(select(i32(_e664), i32(-2147483648), (_e664 < -2147483600f)), 2147483647i, (_e664 > 2147483500f)), (_e664 == _e664));
let _e675 = (_e671 - select(0i, 1i, (_e664 < f32(_e671))));
let _e677 = select(-1f, _e491, (_e491 > -1f));
let _e679 = select(_e486, _e677, (_e677 < _e486));
let _e686 = select(0i, select(select(i32(_e679), i32(-2147483648), (_e679 < -2147483600f)), 2147483647i, (_e679 > 2147483500f)), (_e679 == _e679));
let _e690 = (_e686 - select(0i, 1i, (_e679 < f32(_e686))));
let _e695 = global_1.member.member_5.member_5[0u];
let _e700 = global_1.member.member_5.member_5[1u];
let _e701 = (_e660 + 1i);
let _e702 = (_e675 + 1i);
let _e703 = (_e690 + 1i);
let _e710 = global_1.member.member_5.member_7[0u];
let _e717 = global_1.member.member_5.member_7[1u];
let _e723 = ((_e701 >> bitcast<u32>(4i)) + (_e710 * ((_e702 >> bitcast<u32>(4i)) + (_e717 * (_e703 >> bitcast<u32>(4i))))));
let _e725 = (bitcast<i32>(_e93) - 1i);
let _e727 = select(_e725, _e723, (_e723 < _e725));
let _e733 = global_2.member[bitcast<u32>(select(0i, _e727, (_e727 > 0i)))];
let _e735 = (_e701 & 15i);
let _e738 = ((_e702 & 15i) * _e695);
let _e740 = (bitcast<i32>(_e733) + ((_e703 & 15i) * _e700));
let _e744 = (_e738 + _e695);
let _e746 = (_e738 + (2i * _e695));
let _e747 = (_e740 + _e700);
let _e749 = (_e740 + (2i * _e700));
local_2 = type_18(array<i32, 4>(_e735, (_e735 + 1i), (_e735 + 2i), (_e735 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_3 = vec3<f32>((_e471 - f32(_e660)), (_e481 - f32(_e675)), (_e491 - f32(_e690)));
let _e763 = local_2.member[1u];
let _e764 = ((_e747 + _e744) + _e763);
let _e766 = (_e764 >> bitcast<u32>(1i));
let _e769 = bitcast<u32>(((_e764 & 1i) * 16i));
let _e771 = select(_e725, _e766, (_e766 < _e725));
let _e776 = global_2.member[bitcast<u32>(select(0i, _e771, (_e771 > 0i)))];
let _e780 = (_e766 + 1i);
let _e782 = select(_e725, _e780, (_e780 < _e725));
let _e787 = global_2.member[bitcast<u32>(select(0i, _e782, (_e782 > 0i)))];
let _e794 = ((_e776 >> bitcast<u32>((_e769 & 31u))) | ((_e787 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e769) & 31u))));
let _e797 = local_2.member_1[2u];
let _e803 = f32(bitcast<i32>(((_e794 >> bitcast<u32>((_e797 & 31u))) & 65535u)));
let _e806 = local_2.member_1[3u];
let _e813 = local_3[0u];
let _e816 = (_e803 + ((f32(bitcast<i32>(((_e794 >> bitcast<u32>((_e806 & 31u))) & 65535u))) - _e803) * _e813));
let _e818 = local_2.member[1u];
let _e819 = ((_e747 + _e746) + _e818);
let _e821 = (_e819 >> bitcast<u32>(1i));
let _e824 = bitcast<u32>(((_e819 & 1i) * 16i));
let _e826 = select(_e725, _e821, (_e821 < _e725));
let _e831 = global_2.member[bitcast<u32>(select(0i, _e826, (_e826 > 0i)))];
let _e835 = (_e821 + 1i);
let _e837 = select(_e725, _e835, (_e835 < _e725));
let _e842 = global_2.member[bitcast<u32>(select(0i, _e837, (_e837 > 0i)))];
let _e849 = ((_e831 >> bitcast<u32>((_e824 & 31u))) | ((_e842 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e824) & 31u))));
let _e850 = local_2.member_1[2u];
let _e856 = f32(bitcast<i32>(((_e849 >> bitcast<u32>((_e850 & 31u))) & 65535u)));
let _e857 = local_2.member_1[3u];
let _e864 = local_3[0u];
let _e869 = local_3[1u];
let _e872 = (_e816 + (((_e856 + ((f32(bitcast<i32>(((_e849 >> bitcast<u32>((_e857 & 31u))) & 65535u))) - _e856) * _e864)) - _e816) * _e869));
let _e874 = local_2.member[1u];
let _e875 = ((_e749 + _e744) + _e874);
let _e877 = (_e875 >> bitcast<u32>(1i));
let _e880 = bitcast<u32>(((_e875 & 1i) * 16i));
let _e882 = select(_e725, _e877, (_e877 < _e725));
let _e887 = global_2.member[bitcast<u32>(select(0i, _e882, (_e882 > 0i)))];
let _e891 = (_e877 + 1i);
let _e893 = select(_e725, _e891, (_e891 < _e725));
let _e898 = global_2.member[bitcast<u32>(select(0i, _e893, (_e893 > 0i)))];
let _e905 = ((_e887 >> bitcast<u32>((_e880 & 31u))) | ((_e898 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e880) & 31u))));
let _e906 = local_2.member_1[2u];
let _e912 = f32(bitcast<i32>(((_e905 >> bitcast<u32>((_e906 & 31u))) & 65535u)));
let _e913 = local_2.member_1[3u];
let _e920 = local_3[0u];
let _e923 = (_e912 + ((f32(bitcast<i32>(((_e905 >> bitcast<u32>((_e913 & 31u))) & 65535u))) - _e912) * _e920));
let _e925 = local_2.member[1u];
let _e926 = ((_e749 + _e746) + _e925);
let _e928 = (_e926 >> bitcast<u32>(1i));
let _e931 = bitcast<u32>(((_e926 & 1i) * 16i));
let _e933 = select(_e725, _e928, (_e928 < _e725));
let _e938 = global_2.member[bitcast<u32>(select(0i, _e933, (_e933 > 0i)))];
let _e942 = (_e928 + 1i);
let _e944 = select(_e725, _e942, (_e942 < _e725));
let _e949 = global_2.member[bitcast<u32>(select(0i, _e944, (_e944 > 0i)))];
let _e956 = ((_e938 >> bitcast<u32>((_e931 & 31u))) | ((_e949 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e931) & 31u))));
let _e957 = local_2.member_1[2u];
let _e963 = f32(bitcast<i32>(((_e956 >> bitcast<u32>((_e957 & 31u))) & 65535u)));
let _e964 = local_2.member_1[3u];
let _e971 = local_3[0u];
let _e975 = local_3[1u];
let _e980 = local_3[2u];
let _e988 = global_1.member.member_5.member_4.member;
let _e994 = global_1.member.member_5.member_4.member_1;
let _e995 = (((_e872 + (((_e923 + (((_e963 + ((f32(bitcast<i32>(((_e956 >> bitcast<u32>((_e964 & 31u))) & 65535u))) - _e963) * _e971)) - _e923) * _e975)) - _e872) * _e980)) * _e988) + _e994);
let _e997 = select(0f, _e995, (_e995 > 0f));
phi_7155_ = type_20(select(1f, _e997, (_e997 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2572 = phi_7155_;
let _e2574 = select(-0.5f, _e402, (_e402 > -0.5f));
let _e2576 = select(_e467, _e2574, (_e2574 < _e467));
let _e2578 = select(-0.5f, _e420, (_e420 > -0.5f));
let _e2580 = select(_e477, _e2578, (_e2578 < _e477));
let _e2582 = select(-0.5f, _e438, (_e438 > -0.5f));
let _e2584 = select(_e487, _e2582, (_e2582 < _e487));
let _e2586 = select(-1f, _e2576, (_e2576 > -1f));
let _e2588 = select(_e466, _e2586, (_e2586 < _e466));
let _e2595 = select(0i, select(select(i32(_e2588), i32(-2147483648), (_e2588 < -2147483600f)), 2147483647i, (_e2588 > 2147483500f)), (_e2588 == _e2588));
let _e2599 = (_e2595 - select(0i, 1i, (_e2588 < f32(_e2595))));
let _e2601 = select(-1f, _e2580, (_e2580 > -1f));
let _e2603 = select(_e476, _e2601, (_e2601 < _e476));
let _e2610 = select(0i, select(select(i32(_e2603), i32(-2147483648), (_e2603 < -2147483600f)), 2147483647i, (_e2603 > 2147483500f)), (_e2603 == _e2603));
let _e2614 = (_e2610 - select(0i, 1i, (_e2603 < f32(_e2610))));
let _e2616 = select(-1f, _e2584, (_e2584 > -1f));
let _e2618 = select(_e486, _e2616, (_e2616 < _e486));
let _e2625 = select(0i, select(select(i32(_e2618), i32(-2147483648), (_e2618 < -2147483600f)), 2147483647i, (_e2618 > 2147483500f)), (_e2618 == _e2618));
let _e2629 = (_e2625 - select(0i, 1i, (_e2618 < f32(_e2625))));
let _e2634 = global_1.member.member_5.member_5[0u];
let _e2639 = global_1.member.member_5.member_5[1u];
let _e2640 = (_e2599 + 1i);
let _e2641 = (_e2614 + 1i);
let _e2642 = (_e2629 + 1i);
let _e2649 = global_1.member.member_5.member_7[0u];
let _e2656 = global_1.member.member_5.member_7[1u];
let _e2662 = ((_e2640 >> bitcast<u32>(4i)) + (_e2649 * ((_e2641 >> bitcast<u32>(4i)) + (_e2656 * (_e2642 >> bitcast<u32>(4i))))));
let _e2664 = (bitcast<i32>(_e93) - 1i);
let _e2666 = select(_e2664, _e2662, (_e2662 < _e2664));
let _e2672 = global_2.member[bitcast<u32>(select(0i, _e2666, (_e2666 > 0i)))];
let _e2674 = (_e2640 & 15i);
let _e2677 = ((_e2641 & 15i) * _e2634);
let _e2679 = (bitcast<i32>(_e2672) + ((_e2642 & 15i) * _e2639));
let _e2683 = (_e2677 + _e2634);
let _e2685 = (_e2677 + (2i * _e2634));
let _e2686 = (_e2679 + _e2639);
let _e2688 = (_e2679 + (2i * _e2639));
local = type_18(array<i32, 4>(_e2674, (_e2674 + 1i), (_e2674 + 2i), (_e2674 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_1 = vec3<f32>((_e2576 - f32(_e2599)), (_e2580 - f32(_e2614)), (_e2584 - f32(_e2629)));
let _e2702 = local.member[1u];
let _e2703 = ((_e2686 + _e2683) + _e2702);
let _e2705 = (_e2703 >> bitcast<u32>(1i));
let _e2708 = bitcast<u32>(((_e2703 & 1i) * 16i));
let _e2710 = select(_e2664, _e2705, (_e2705 < _e2664));
let _e2715 = global_2.member[bitcast<u32>(select(0i, _e2710, (_e2710 > 0i)))];
let _e2719 = (_e2705 + 1i);
let _e2721 = select(_e2664, _e2719, (_e2719 < _e2664));
let _e2726 = global_2.member[bitcast<u32>(select(0i, _e2721, (_e2721 > 0i)))];
let _e2733 = ((_e2715 >> bitcast<u32>((_e2708 & 31u))) | ((_e2726 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2708) & 31u))));
let _e2736 = local.member_1[2u];
let _e2742 = f32(bitcast<i32>(((_e2733 >> bitcast<u32>((_e2736 & 31u))) & 65535u)));
let _e2745 = local.member_1[3u];
let _e2752 = local_1[0u];
let _e2755 = (_e2742 + ((f32(bitcast<i32>(((_e2733 >> bitcast<u32>((_e2745 & 31u))) & 65535u))) - _e2742) * _e2752));
let _e2757 = local.member[1u];
let _e2758 = ((_e2686 + _e2685) + _e2757);
let _e2760 = (_e2758 >> bitcast<u32>(1i));
let _e2763 = bitcast<u32>(((_e2758 & 1i) * 16i));
let _e2765 = select(_e2664, _e2760, (_e2760 < _e2664));
let _e2770 = global_2.member[bitcast<u32>(select(0i, _e2765, (_e2765 > 0i)))];
let _e2774 = (_e2760 + 1i);
let _e2776 = select(_e2664, _e2774, (_e2774 < _e2664));
let _e2781 = global_2.member[bitcast<u32>(select(0i, _e2776, (_e2776 > 0i)))];
let _e2788 = ((_e2770 >> bitcast<u32>((_e2763 & 31u))) | ((_e2781 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2763) & 31u))));
let _e2789 = local.member_1[2u];
let _e2795 = f32(bitcast<i32>(((_e2788 >> bitcast<u32>((_e2789 & 31u))) & 65535u)));
let _e2796 = local.member_1[3u];
let _e2803 = local_1[0u];
let _e2808 = local_1[1u];
let _e2811 = (_e2755 + (((_e2795 + ((f32(bitcast<i32>(((_e2788 >> bitcast<u32>((_e2796 & 31u))) & 65535u))) - _e2795) * _e2803)) - _e2755) * _e2808));
let _e2813 = local.member[1u];
let _e2814 = ((_e2688 + _e2683) + _e2813);
let _e2816 = (_e2814 >> bitcast<u32>(1i));
let _e2819 = bitcast<u32>(((_e2814 & 1i) * 16i));
let _e2821 = select(_e2664, _e2816, (_e2816 < _e2664));
let _e2826 = global_2.member[bitcast<u32>(select(0i, _e2821, (_e2821 > 0i)))];
let _e2830 = (_e2816 + 1i);
let _e2832 = select(_e2664, _e2830, (_e2830 < _e2664));
let _e2837 = global_2.member[bitcast<u32>(select(0i, _e2832, (_e2832 > 0i)))];
let _e2844 = ((_e2826 >> bitcast<u32>((_e2819 & 31u))) | ((_e2837 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2819) & 31u))));
let _e2845 = local.member_1[2u];
let _e2851 = f32(bitcast<i32>(((_e2844 >> bitcast<u32>((_e2845 & 31u))) & 65535u)));
let _e2852 = local.member_1[3u];
let _e2859 = local_1[0u];
let _e2862 = (_e2851 + ((f32(bitcast<i32>(((_e2844 >> bitcast<u32>((_e2852 & 31u))) & 65535u))) - _e2851) * _e2859));
let _e2864 = local.member[1u];
let _e2865 = ((_e2688 + _e2685) + _e2864);
let _e2867 = (_e2865 >> bitcast<u32>(1i));
let _e2870 = bitcast<u32>(((_e2865 & 1i) * 16i));
let _e2872 = select(_e2664, _e2867, (_e2867 < _e2664));
let _e2877 = global_2.member[bitcast<u32>(select(0i, _e2872, (_e2872 > 0i)))];
let _e2881 = (_e2867 + 1i);
let _e2883 = select(_e2664, _e2881, (_e2881 < _e2664));
let _e2888 = global_2.member[bitcast<u32>(select(0i, _e2883, (_e2883 > 0i)))];
let _e2895 = ((_e2877 >> bitcast<u32>((_e2870 & 31u))) | ((_e2888 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2870) & 31u))));
let _e2896 = local.member_1[2u];
let _e2902 = f32(bitcast<i32>(((_e2895 >> bitcast<u32>((_e2896 & 31u))) & 65535u)));
let _e2903 = local.member_1[3u];
let _e2910 = local_1[0u];
let _e2914 = local_1[1u];
let _e2919 = local_1[2u];
let _e2927 = global_1.member.member_5.member_4.member;
let _e2933 = global_1.member.member_5.member_4.member_1;
let _e2934 = (((_e2811 + (((_e2862 + (((_e2902 + ((f32(bitcast<i32>(((_e2895 >> bitcast<u32>((_e2903 & 31u))) & 65535u))) - _e2902) * _e2910)) - _e2862) * _e2914)) - _e2811) * _e2919)) * _e2927) + _e2933);
let _e2936 = select(0f, _e2934, (_e2934 > 0f));
if ((_e625 & 16u) == 0u) {
phi_8676_ = type_21(1f, 1f, 1f);
} else {
let _e2943 = global_1.member.member_18;
let _e2947 = global_1.member.member_22.member;
let _e2957 = ((((_e2943.member * _e310) + (_e2943.member_1 * _e319)) + (_e2943.member_2 * _e292)) + _e2943.member_3);
let _e2963 = ((((_e2943.member * _e331) + (_e2943.member_1 * _e336)) + (_e2943.member_2 * _e325)) + _e2943.member_3);
let _e2965 = select(_e2963, _e2957, (_e2957 < _e2963));
let _e2967 = select(_e2963, _e2957, (_e2957 > _e2963));
let _e2969 = (_e2967 - _e2965);
let _e2972 = (-(_e2965) / select(1e-30f, _e2969, (_e2969 > 1e-30f)));
let _e2974 = select(0f, _e2972, (_e2972 > 0f));
let _e2980 = select(select(select(1f, _e2974, (_e2974 < 1f)), 1f, (_e2967 <= 0f)), 0f, (_e2965 > 0f));
let _e2982 = (_e2947 > 0.5f);
let _e2991 = global_1.member.member_19;
let _e2995 = global_1.member.member_22.member_1;
let _e3005 = ((((_e2991.member * _e310) + (_e2991.member_1 * _e319)) + (_e2991.member_2 * _e292)) + _e2991.member_3);
let _e3011 = ((((_e2991.member * _e331) + (_e2991.member_1 * _e336)) + (_e2991.member_2 * _e325)) + _e2991.member_3);
let _e3013 = select(_e3011, _e3005, (_e3005 < _e3011));
let _e3015 = select(_e3011, _e3005, (_e3005 > _e3011));
let _e3017 = (_e3015 - _e3013);
let _e3020 = (-(_e3013) / select(1e-30f, _e3017, (_e3017 > 1e-30f)));
let _e3022 = select(0f, _e3020, (_e3020 > 0f));
let _e3028 = select(select(select(1f, _e3022, (_e3022 < 1f)), 1f, (_e3015 <= 0f)), 0f, (_e3013 > 0f));
let _e3030 = (_e2995 > 0.5f);
let _e3039 = global_1.member.member_20;
let _e3043 = global_1.member.member_22.member_2;
let _e3053 = ((((_e3039.member * _e310) + (_e3039.member_1 * _e319)) + (_e3039.member_2 * _e292)) + _e3039.member_3);
let _e3059 = ((((_e3039.member * _e331) + (_e3039.member_1 * _e336)) + (_e3039.member_2 * _e325)) + _e3039.member_3);
let _e3061 = select(_e3059, _e3053, (_e3053 < _e3059));
let _e3063 = select(_e3059, _e3053, (_e3053 > _e3059));
let _e3065 = (_e3063 - _e3061);
let _e3068 = (-(_e3061) / select(1e-30f, _e3065, (_e3065 > 1e-30f)));
let _e3070 = select(0f, _e3068, (_e3068 > 0f));
let _e3076 = select(select(select(1f, _e3070, (_e3070 < 1f)), 1f, (_e3063 <= 0f)), 0f, (_e3061 > 0f));
let _e3078 = (_e3043 > 0.5f);
let _e3087 = global_1.member.member_21;
let _e3091 = global_1.member.member_22.member_3;
let _e3101 = ((((_e3087.member * _e310) + (_e3087.member_1 * _e319)) + (_e3087.member_2 * _e292)) + _e3087.member_3);
let _e3107 = ((((_e3087.member * _e331) + (_e3087.member_1 * _e336)) + (_e3087.member_2 * _e325)) + _e3087.member_3);
let _e3109 = select(_e3107, _e3101, (_e3101 < _e3107));
let _e3111 = select(_e3107, _e3101, (_e3101 > _e3107));
let _e3113 = (_e3111 - _e3109);
let _e3116 = (-(_e3109) / select(1e-30f, _e3113, (_e3113 > 1e-30f)));
let _e3118 = select(0f, _e3116, (_e3116 > 0f));
let _e3124 = select(select(select(1f, _e3118, (_e3118 < 1f)), 1f, (_e3111 <= 0f)), 0f, (_e3109 > 0f));
let _e3126 = (_e3091 > 0.5f);
phi_8676_ = type_21(((((1f * _e2980) * _e3028) * _e3076) * _e3124), ((((1f * select(1f, _e2980, _e2982)) * select(1f, _e3028, _e3030)) * select(1f, _e3076, _e3078)) * select(1f, _e3124, _e3126)), ((((1f * select(1f, 0f, (_e2982 && (_e2963 > 0f)))) * select(1f, 0f, (_e3030 && (_e3011 > 0f)))) * select(1f, 0f, (_e3078 && (_e3059 > 0f)))) * select(1f, 0f, (_e3126 && (_e3107 > 0f)))));
}
let _e3135 = phi_8676_;
let _e3136 = (_e331 - _e310);
let _e3137 = (_e336 - _e319);
let _e3138 = (_e325 - _e292);
let _e3143 = (((_e3136 * _e3136) + (_e3137 * _e3137)) + (_e3138 * _e3138));
let _e3147 = (_e497 < 1e-12f);
let _e3149 = (1f / select(_e492, 1f, _e3147));
let _e3151 = ((-0.5f - _e402) * _e3149);
let _e3153 = ((_e467 - _e402) * _e3149);
let _e3159 = select(_e3153, _e3151, (_e3151 < _e3153));
let _e3161 = select(0f, _e3159, (_e3159 > 0f));
let _e3164 = select(select(1f, _e3161, (_e3161 < 1f)), select(2f, 0f, ((_e402 >= -0.5f) && (_e402 <= _e467))), _e3147);
let _e3166 = select(_e3153, _e3151, (_e3151 > _e3153));
let _e3168 = select(0f, _e3166, (_e3166 > 0f));
let _e3171 = select(select(1f, _e3168, (_e3168 < 1f)), 1f, _e3147);
let _e3172 = (_e500 < 1e-12f);
let _e3174 = (1f / select(_e493, 1f, _e3172));
let _e3176 = ((-0.5f - _e420) * _e3174);
let _e3178 = ((_e477 - _e420) * _e3174);
let _e3184 = select(_e3178, _e3176, (_e3176 < _e3178));
let _e3186 = select(0f, _e3184, (_e3184 > 0f));
let _e3189 = select(select(1f, _e3186, (_e3186 < 1f)), select(2f, 0f, ((_e420 >= -0.5f) && (_e420 <= _e477))), _e3172);
let _e3191 = select(_e3178, _e3176, (_e3176 > _e3178));
let _e3193 = select(0f, _e3191, (_e3191 > 0f));
let _e3196 = select(select(1f, _e3193, (_e3193 < 1f)), 1f, _e3172);
let _e3197 = (_e505 < 1e-12f);
let _e3199 = (1f / select(_e494, 1f, _e3197));
let _e3201 = ((-0.5f - _e438) * _e3199);
let _e3203 = ((_e487 - _e438) * _e3199);
let _e3209 = select(_e3203, _e3201, (_e3201 < _e3203));
let _e3211 = select(0f, _e3209, (_e3209 > 0f));
let _e3214 = select(select(1f, _e3211, (_e3211 < 1f)), select(2f, 0f, ((_e438 >= -0.5f) && (_e438 <= _e487))), _e3197);
let _e3216 = select(_e3203, _e3201, (_e3201 > _e3203));
let _e3218 = select(0f, _e3216, (_e3216 > 0f));
let _e3221 = select(select(1f, _e3218, (_e3218 < 1f)), 1f, _e3197);
let _e3223 = select(_e3196, _e3171, (_e3171 < _e3196));
let _e3227 = select(_e3189, _e3164, (_e3164 > _e3189));
let _e3230 = (select(_e3221, _e3223, (_e3223 < _e3221)) - select(_e3214, _e3227, (_e3227 > _e3214)));
let _e3237 = global_1.member.member_4.member_3;
let _e3238 = ((sqrt(select(0f, _e3143, (_e3143 > 0f))) * select(0f, _e3230, (_e3230 > 0f))) * _e3237);
let _e3240 = (select(1f, _e2936, (_e2936 < 1f)) * 255f);
let _e3241 = (_e2572.member * 255f);
let _e3242 = (255f - 1f);
let _e3244 = select(0f, _e3240, (_e3240 > 0f));
let _e3246 = select(_e3242, _e3244, (_e3244 < _e3242));
let _e3253 = select(0i, select(select(i32(_e3246), i32(-2147483648), (_e3246 < -2147483600f)), 2147483647i, (_e3246 > 2147483500f)), (_e3246 == _e3246));
let _e3257 = (_e3253 - select(0i, 1i, (_e3246 < f32(_e3253))));
let _e3259 = select(0f, _e3241, (_e3241 > 0f));
let _e3261 = select(_e3242, _e3259, (_e3259 < _e3242));
let _e3268 = select(0i, select(select(i32(_e3261), i32(-2147483648), (_e3261 < -2147483600f)), 2147483647i, (_e3261 > 2147483500f)), (_e3261 == _e3261));
let _e3272 = (_e3268 - select(0i, 1i, (_e3261 < f32(_e3268))));
let _e3275 = (((_e3257 * 256i) + _e3272) * 4i);
let _e3277 = (_e3240 - f32(_e3257));
let _e3279 = (_e3241 - f32(_e3272));
let _e3281 = (bitcast<i32>(_e97) - 1i);
let _e3283 = select(_e3281, _e3275, (_e3275 < _e3281));
let _e3289 = global_4.member[bitcast<u32>(select(0i, _e3283, (_e3283 > 0i)))];
let _e3290 = (_e3275 + 4i);
let _e3292 = select(_e3281, _e3290, (_e3290 < _e3281));
let _e3298 = global_4.member[bitcast<u32>(select(0i, _e3292, (_e3292 > 0i)))];
let _e3299 = (_e3275 + 1024i);
let _e3301 = select(_e3281, _e3299, (_e3299 < _e3281));
let _e3307 = global_4.member[bitcast<u32>(select(0i, _e3301, (_e3301 > 0i)))];
let _e3308 = (_e3275 + 1028i);
let _e3310 = select(_e3281, _e3308, (_e3308 < _e3281));
let _e3316 = global_4.member[bitcast<u32>(select(0i, _e3310, (_e3310 > 0i)))];
let _e3321 = (bitcast<f32>(((_e3289 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3329 = (_e3321 + (((bitcast<f32>(((_e3298 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3321) * _e3279));
let _e3334 = (bitcast<f32>(((_e3307 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3358 = (bitcast<f32>((((_e3289 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3366 = (_e3358 + (((bitcast<f32>((((_e3298 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3358) * _e3279));
let _e3371 = (bitcast<f32>((((_e3307 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3383 = (_e3275 + 1i);
let _e3385 = select(_e3281, _e3383, (_e3383 < _e3281));
let _e3391 = global_4.member[bitcast<u32>(select(0i, _e3385, (_e3385 > 0i)))];
let _e3392 = (_e3275 + 5i);
let _e3394 = select(_e3281, _e3392, (_e3392 < _e3281));
let _e3400 = global_4.member[bitcast<u32>(select(0i, _e3394, (_e3394 > 0i)))];
let _e3401 = (_e3275 + 1025i);
let _e3403 = select(_e3281, _e3401, (_e3401 < _e3281));
let _e3409 = global_4.member[bitcast<u32>(select(0i, _e3403, (_e3403 > 0i)))];
let _e3410 = (_e3275 + 1029i);
let _e3412 = select(_e3281, _e3410, (_e3410 < _e3281));
let _e3418 = global_4.member[bitcast<u32>(select(0i, _e3412, (_e3412 > 0i)))];
let _e3423 = (bitcast<f32>(((_e3391 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3431 = (_e3423 + (((bitcast<f32>(((_e3400 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3423) * _e3279));
let _e3436 = (bitcast<f32>(((_e3409 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3460 = (bitcast<f32>((((_e3391 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3468 = (_e3460 + (((bitcast<f32>((((_e3400 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3460) * _e3279));
let _e3473 = (bitcast<f32>((((_e3409 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3488 = (_e3238 * _e3135.member_1);
let _e3490 = -(((_e3366 + (((_e3371 + (((bitcast<f32>((((_e3316 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3371) * _e3279)) - _e3366) * _e3277)) * _e3488));
let _e3492 = select(-87f, _e3490, (_e3490 > -87f));
let _e3494 = select(88f, _e3492, (_e3492 < 88f));
let _e3496 = ((_e3494 * 1.442695f) + 0.5f);
let _e3498 = select(-127f, _e3496, (_e3496 > -127f));
let _e3500 = select(128f, _e3498, (_e3498 < 128f));
let _e3507 = select(0i, select(select(i32(_e3500), i32(-2147483648), (_e3500 < -2147483600f)), 2147483647i, (_e3500 > 2147483500f)), (_e3500 == _e3500));
let _e3511 = (_e3507 - select(0i, 1i, (_e3500 < f32(_e3507))));
let _e3512 = f32(_e3511);
let _e3516 = ((_e3494 - (_e3512 * 0.6933594f)) - (_e3512 * -2.1219444e-4f));
let _e3538 = -(((_e3431 + (((_e3436 + (((bitcast<f32>(((_e3418 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3436) * _e3279)) - _e3431) * _e3277)) * _e3488));
let _e3540 = select(-87f, _e3538, (_e3538 > -87f));
let _e3542 = select(88f, _e3540, (_e3540 < 88f));
let _e3544 = ((_e3542 * 1.442695f) + 0.5f);
let _e3546 = select(-127f, _e3544, (_e3544 > -127f));
let _e3548 = select(128f, _e3546, (_e3546 < 128f));
let _e3555 = select(0i, select(select(i32(_e3548), i32(-2147483648), (_e3548 < -2147483600f)), 2147483647i, (_e3548 > 2147483500f)), (_e3548 == _e3548));
let _e3559 = (_e3555 - select(0i, 1i, (_e3548 < f32(_e3555))));
let _e3560 = f32(_e3559);
let _e3564 = ((_e3542 - (_e3560 * 0.6933594f)) - (_e3560 * -2.1219444e-4f));
let _e3586 = -(((_e3468 + (((_e3473 + (((bitcast<f32>((((_e3418 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3473) * _e3279)) - _e3468) * _e3277)) * _e3488));
let _e3588 = select(-87f, _e3586, (_e3586 > -87f));
let _e3590 = select(88f, _e3588, (_e3588 < 88f));
let _e3592 = ((_e3590 * 1.442695f) + 0.5f);
let _e3594 = select(-127f, _e3592, (_e3592 > -127f));
let _e3596 = select(128f, _e3594, (_e3594 < 128f));
let _e3603 = select(0i, select(select(i32(_e3596), i32(-2147483648), (_e3596 < -2147483600f)), 2147483647i, (_e3596 > 2147483500f)), (_e3596 == _e3596));
let _e3607 = (_e3603 - select(0i, 1i, (_e3596 < f32(_e3603))));
let _e3608 = f32(_e3607);
let _e3612 = ((_e3590 - (_e3608 * 0.6933594f)) - (_e3608 * -2.1219444e-4f));
let _e3634 = -(((_e3329 + (((_e3334 + (((bitcast<f32>(((_e3316 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3334) * _e3279)) - _e3329) * _e3277)) * (_e3238 * _e3135.member)));
let _e3636 = select(-87f, _e3634, (_e3634 > -87f));
let _e3638 = select(88f, _e3636, (_e3636 < 88f));
let _e3640 = ((_e3638 * 1.442695f) + 0.5f);
let _e3642 = select(-127f, _e3640, (_e3640 > -127f));
let _e3644 = select(128f, _e3642, (_e3642 < 128f));
let _e3651 = select(0i, select(select(i32(_e3644), i32(-2147483648), (_e3644 < -2147483600f)), 2147483647i, (_e3644 > 2147483500f)), (_e3644 == _e3644));
let _e3655 = (_e3651 - select(0i, 1i, (_e3644 < f32(_e3651))));
let _e3656 = f32(_e3655);
let _e3660 = ((_e3638 - (_e3656 * 0.6933594f)) - (_e3656 * -2.1219444e-4f));
let _e3680 = ((1f + (_e3660 * (1f + (_e3660 * (0.5f + (_e3660 * (0.16666667f + (_e3660 * (0.041666668f + (_e3660 * (0.008333334f + (_e3660 * (0.001388889f + (_e3660 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3655 + 127i)) << bitcast<u32>(23i))));
if _e645 {
let _e3695 = global_1.member.member_24.member_2;
let _e3698 = (_e2572.member_3.x * _e3135.member_2);
let _e3700 = (_e2572.member_3.y * _e3135.member_2);
let _e3702 = (_e2572.member_3.z * _e3135.member_2);
let _e3703 = (0.5f * (_e249 / _e201));
let _e3707 = (_e179 + (_e3698 * _e3703));
let _e3708 = (_e190 + (_e3700 * _e3703));
let _e3709 = (_e201 + (_e3702 * _e3703));
let _e3711 = (2f * _e249);
let _e3713 = ((_e3709 * _e3709) + (_e3711 * _e3702));
let _e3717 = (_e3709 + sqrt(select(0f, _e3713, (_e3713 > 0f))));
let _e3721 = (0.5f * (_e3711 / select(1e-6f, _e3717, (_e3717 > 1e-6f))));
let _e3725 = (_e3707 + (_e3698 * _e3721));
let _e3726 = (_e3708 + (_e3700 * _e3721));
let _e3727 = (_e3709 + (_e3702 * _e3721));
let _e3731 = (_e3695 * _e3695);
let _e3733 = (_e3727 * _e3727);
let _e3741 = (((_e3709 <= 0f) || (_e3713 <= 0f)) || ((_e3727 <= 0f) || (_e3733 <= (_e3731 * (((_e3725 * _e3725) + (_e3726 * _e3726)) + _e3733)))));
let _e3755 = (_e179 + ((_e2572.member_4.x * _e3135.member_2) * _e249));
let _e3756 = (_e190 + ((_e2572.member_4.y * _e3135.member_2) * _e249));
let _e3757 = (_e201 + ((_e2572.member_4.z * _e3135.member_2) * _e249));
let _e3759 = (_e3757 * _e3757);
let _e3768 = ((_e625 & 1u) != 0u);
phi_9700_ = select(select(select(_e3727, _e3709, _e3741), _e3757, _e3768), _e201, _e632);
phi_9701_ = select(select(select(_e3726, _e3708, _e3741), _e3756, _e3768), _e190, _e632);
phi_9702_ = select(select(select(_e3725, _e3707, _e3741), _e3755, _e3768), _e179, _e632);
phi_9703_ = (select(_e3741, ((_e3757 <= 0f) || (_e3759 <= (_e3731 * (((_e3755 * _e3755) + (_e3756 * _e3756)) + _e3759)))), _e3768) && !(_e632));
} else {
phi_9700_ = _e201;
phi_9701_ = _e190;
phi_9702_ = _e179;
phi_9703_ = false;
}
let _e3779 = phi_9700_;
let _e3781 = phi_9701_;
let _e3783 = phi_9702_;
let _e3785 = phi_9703_;
global_6.member[_e125] = (_e136 + _e264);
global_6.member[_e137] = (_e146 + _e271);
global_6.member[_e148] = (_e157 + _e373);
global_6.member[_e159] = (_e168 + _e376);
global_6.member[_e170] = _e3783;
global_6.member[_e181] = _e3781;
global_6.member[_e192] = _e3779;
global_6.member[_e203] = select((_e212 * (((1f + (_e3516 * (1f + (_e3516 * (0.5f + (_e3516 * (0.16666667f + (_e3516 * (0.041666668f + (_e3516 * (0.008333334f + (_e3516 * (0.001388889f + (_e3516 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3511 + 127i)) << bitcast<u32>(23i)))) * _e3680)), _e212, _e632);
global_6.member[_e214] = select((_e223 * (((1f + (_e3564 * (1f + (_e3564 * (0.5f + (_e3564 * (0.16666667f + (_e3564 * (0.041666668f + (_e3564 * (0.008333334f + (_e3564 * (0.001388889f + (_e3564 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3559 + 127i)) << bitcast<u32>(23i)))) * _e3680)), _e223, _e632);
global_6.member[_e225] = select((_e234 * (((1f + (_e3612 * (1f + (_e3612 * (0.5f + (_e3612 * (0.16666667f + (_e3612 * (0.041666668f + (_e3612 * (0.008333334f + (_e3612 * (0.001388889f + (_e3612 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3607 + 127i)) << bitcast<u32>(23i)))) * _e3680)), _e234, _e632);
global_6.member[_e236] = select(_e245, 1f, _e3785);
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
