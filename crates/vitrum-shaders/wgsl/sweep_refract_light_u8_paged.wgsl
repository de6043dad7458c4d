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
struct type_22 {
member: f32,
member_1: f32,
member_2: vec3<f32>,
member_3: vec3<f32>,
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
@group(0) @binding(6)
var<storage, read_write> global_5: type_6;
@group(0) @binding(5)
var<storage> global_6: type_6;
fn function_() {
var local: type_18;
var local_1: vec3<f32>;
var local_2: type_18;
var local_3: vec3<f32>;
var local_4: type_18;
var local_5: vec3<f32>;
var phi_944_: u32;
var phi_5328_: type_19;
var phi_6649_: type_20;
var phi_8135_: type_21;
var phi_9245_: type_22;
var phi_9396_: f32;
var phi_9397_: f32;
var phi_9398_: f32;
var phi_9399_: f32;
let _e88 = global;
let _e91 = arrayLength((&global_2.member));
let _e95 = arrayLength((&global_4.member));
let _e97 = arrayLength((&global_6.member));
let _e102 = global_1.member.member_1;
let _e105 = (_e88.x + _e102.x);
let _e108 = (_e88.y + _e102.y);
if (_e105 < _e102.z) {
if (_e108 < _e102.w) {
let _e116 = global_1.member.member[0u];
let _e120 = global_1.member.member[1u];
let _e121 = (_e116 * _e120);
let _e123 = ((_e108 * _e116) + _e105);
let _e124 = bitcast<i32>(_e123);
let _e126 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e128 = select(_e126, _e124, (_e124 < _e126));
let _e134 = global_5.member[bitcast<u32>(select(0i, _e128, (_e128 > 0i)))];
let _e135 = (_e121 + _e123);
let _e136 = bitcast<i32>(_e135);
let _e138 = select(_e126, _e136, (_e136 < _e126));
let _e144 = global_5.member[bitcast<u32>(select(0i, _e138, (_e138 > 0i)))];
let _e146 = ((2u * _e121) + _e123);
let _e147 = bitcast<i32>(_e146);
let _e149 = select(_e126, _e147, (_e147 < _e126));
let _e155 = global_5.member[bitcast<u32>(select(0i, _e149, (_e149 > 0i)))];
let _e157 = ((3u * _e121) + _e123);
let _e158 = bitcast<i32>(_e157);
let _e160 = select(_e126, _e158, (_e158 < _e126));
let _e166 = global_5.member[bitcast<u32>(select(0i, _e160, (_e160 > 0i)))];
let _e168 = ((4u * _e121) + _e123);
let _e169 = bitcast<i32>(_e168);
let _e171 = select(_e126, _e169, (_e169 < _e126));
let _e177 = global_5.member[bitcast<u32>(select(0i, _e171, (_e171 > 0i)))];
let _e179 = ((5u * _e121) + _e123);
let _e180 = bitcast<i32>(_e179);
let _e182 = select(_e126, _e180, (_e180 < _e126));
let _e188 = global_5.member[bitcast<u32>(select(0i, _e182, (_e182 > 0i)))];
let _e190 = ((6u * _e121) + _e123);
let _e191 = bitcast<i32>(_e190);
let _e193 = select(_e126, _e191, (_e191 < _e126));
let _e199 = global_5.member[bitcast<u32>(select(0i, _e193, (_e193 > 0i)))];
let _e201 = ((7u * _e121) + _e123);
let _e202 = bitcast<i32>(_e201);
let _e204 = select(_e126, _e202, (_e202 < _e126));
let _e210 = global_5.member[bitcast<u32>(select(0i, _e204, (_e204 > 0i)))];
let _e212 = ((8u * _e121) + _e123);
let _e213 = bitcast<i32>(_e212);
let _e215 = select(_e126, _e213, (_e213 < _e126));
let _e221 = global_5.member[bitcast<u32>(select(0i, _e215, (_e215 > 0i)))];
let _e225 = global_1.member.member_2[2u];
let _e229 = global_1.member.member_2[3u];
let _e230 = (_e225 * _e229);
if (_e97 >= (_e230 * 2u)) {
let _e234 = bitcast<i32>((_e108 * _e225));
let _e236 = bitcast<i32>(_e105);
let _e241 = global_6.member[bitcast<u32>((_e234 + _e236))];
let _e247 = global_6.member[bitcast<u32>(((bitcast<i32>(_e230) + _e234) + _e236))];
let _e248 = f32(_e236);
let _e250 = f32(bitcast<i32>(_e108));
let _e256 = global_1.member.member_4.member;
let _e260 = global_1.member.member_8.member_2;
let _e261 = (_e256 - _e260);
let _e265 = global_1.member.member_7.member;
let _e269 = global_1.member.member_8.member;
let _e276 = global_1.member.member_7.member_2;
let _e278 = ((_e265 + (_e269 * _e261)) + (((_e248 - _e241) + 0.5f) * _e276));
let _e282 = global_1.member.member_7.member_1;
let _e286 = global_1.member.member_8.member_1;
let _e291 = ((_e282 + (_e286 * _e261)) + (((_e250 - _e247) + 0.5f) * _e276));
let _e295 = global_1.member.member_4.member_1;
let _e296 = (_e295 - _e260);
let _e301 = ((_e265 + (_e269 * _e296)) + ((_e248 + 0.5f) * _e276));
let _e306 = ((_e282 + (_e286 * _e296)) + ((_e250 + 0.5f) * _e276));
let _e310 = global_1.member.member_5.member;
let _e323 = global_1.member.member_5.member.member_3;
let _e324 = ((((_e310.member * _e278) + (_e310.member_1 * _e291)) + (_e310.member_2 * _e256)) + _e323);
let _e328 = global_1.member.member_5.member_1;
let _e341 = global_1.member.member_5.member_1.member_3;
let _e342 = ((((_e328.member * _e278) + (_e328.member_1 * _e291)) + (_e328.member_2 * _e256)) + _e341);
let _e346 = global_1.member.member_5.member_2;
let _e359 = global_1.member.member_5.member_2.member_3;
let _e360 = ((((_e346.member * _e278) + (_e346.member_1 * _e291)) + (_e346.member_2 * _e256)) + _e359);
let _e366 = ((((_e310.member * _e301) + (_e310.member_1 * _e306)) + (_e310.member_2 * _e295)) + _e323);
let _e372 = ((((_e328.member * _e301) + (_e328.member_1 * _e306)) + (_e328.member_2 * _e295)) + _e341);
let _e378 = ((((_e346.member * _e301) + (_e346.member_1 * _e306)) + (_e346.member_2 * _e295)) + _e359);
let _e384 = global_1.member.member_5.member_3.member;
let _e385 = (_e384 - 1f);
let _e394 = global_1.member.member_5.member_3.member_1;
let _e395 = (_e394 - 1f);
let _e404 = global_1.member.member_5.member_3.member_2;
let _e405 = (_e404 - 1f);
let _e425 = global_1.member.member_5.member_3.member_3;
let _e426 = (_e384 - 0.5f);
let _e428 = select(-0.5f, _e366, (_e366 > -0.5f));
let _e430 = select(_e426, _e428, (_e428 < _e426));
let _e431 = (_e394 - 0.5f);
let _e433 = select(-0.5f, _e372, (_e372 > -0.5f));
let _e435 = select(_e431, _e433, (_e433 < _e431));
let _e436 = (_e404 - 0.5f);
let _e438 = select(-0.5f, _e378, (_e378 > -0.5f));
let _e440 = select(_e436, _e438, (_e438 < _e436));
let _e446 = bitcast<f32>((bitcast<u32>((_e366 - _e324)) & 2147483647u));
let _e449 = bitcast<f32>((bitcast<u32>((_e372 - _e342)) & 2147483647u));
let _e451 = select(_e449, _e446, (_e446 > _e449));
let _e454 = bitcast<f32>((bitcast<u32>((_e378 - _e360)) & 2147483647u));
let _e463 = bitcast<f32>((bitcast<u32>((_e366 - _e430)) & 2147483647u));
let _e466 = bitcast<f32>((bitcast<u32>((_e372 - _e435)) & 2147483647u));
let _e468 = select(_e466, _e463, (_e463 > _e466));
let _e471 = bitcast<f32>((bitcast<u32>((_e378 - _e440)) & 2147483647u));
let _e475 = (_e430 + 0.5f);
let _e477 = select(0f, _e475, (_e475 > 0f));
let _e479 = select(_e385, _e477, (_e477 < _e385));
let _e486 = select(0i, select(select(i32(_e479), i32(-2147483648), (_e479 < -2147483600f)), 2147483647i, (_e479 > 2147483500f)), (_e479 == _e479));
let _e495 = global_1.member.member_5.member_7[3u];
let _e496 = (_e495 & 31i);
let _e499 = (_e435 + 0.5f);
let _e501 = select(0f, _e499, (_e499 > 0f));
let _e503 = select(_e395, _e501, (_e501 < _e395));
let _e510 = select(0i, select(select(i32(_e503), i32(-2147483648), (_e503 < -2147483600f)), 2147483647i, (_e503 > 2147483500f)), (_e503 == _e503));
let _e517 = (_e440 + 0.5f);
let _e519 = select(0f, _e517, (_e517 > 0f));
let _e521 = select(_e405, _e519, (_e519 < _e405));
let _e528 = select(0i, select(select(i32(_e521), i32(-2147483648), (_e521 < -2147483600f)), 2147483647i, (_e521 > 2147483500f)), (_e521 == _e521));
let _e539 = global_1.member.member_5.member_6[3u];
let _e545 = global_1.member.member_5.member_6[0u];
let _e550 = global_1.member.member_5.member_6[1u];
let _e554 = ((_e539 + ((_e486 - select(0i, 1i, (_e479 < f32(_e486)))) >> bitcast<u32>(_e496))) + (_e545 * (((_e510 - select(0i, 1i, (_e503 < f32(_e510)))) >> bitcast<u32>(_e496)) + (_e550 * ((_e528 - select(0i, 1i, (_e521 < f32(_e528)))) >> bitcast<u32>(_e496))))));
let _e556 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e558 = select(_e556, _e554, (_e554 < _e556));
let _e564 = global_3.member[bitcast<u32>(select(0i, _e558, (_e558 > 0i)))];
let _e571 = global_1.member.member[3u];
phi_944_ = select(select(7u, 3u, (((((((_e324 >= 0f) && (_e324 <= _e385)) && (_e342 >= 0f)) && (_e342 <= _e395)) && (_e360 >= 0f)) && (_e360 <= _e405)) && ((((((_e366 >= 0f) && (_e366 <= _e385)) && (_e372 >= 0f)) && (_e372 <= _e395)) && (_e378 >= 0f)) && (_e378 <= _e405)))), 1u, (((_e571 & 64u) != 0u) || ((((select(_e454, _e451, (_e451 > _e454)) <= _e425) && ((select(_e471, _e468, (_e468 > _e471)) > _e425) || (_e564 != 0u))) && true) && ((_e571 & 32u) != 0u))));
} else {
phi_944_ = 7u;
}
let _e581 = phi_944_;
if (_e581 > 1u) {
let _e586 = global_1.member.member[2u];
let _e589 = bitcast<i32>(((_e108 * _e225) + _e105));
let _e592 = (bitcast<i32>(_e97) - 1i);
let _e594 = select(_e592, _e589, (_e589 < _e592));
let _e600 = global_6.member[bitcast<u32>(select(0i, _e594, (_e594 > 0i)))];
let _e601 = (bitcast<i32>(_e230) + _e589);
let _e603 = select(_e592, _e601, (_e601 < _e592));
let _e609 = global_6.member[bitcast<u32>(select(0i, _e603, (_e603 > 0i)))];
let _e611 = f32(bitcast<i32>(_e105));
let _e613 = f32(bitcast<i32>(_e108));
let _e619 = global_1.member.member_4.member;
let _e623 = global_1.member.member_8.member_2;
let _e624 = (_e619 - _e623);
let _e628 = global_1.member.member_7.member;
let _e632 = global_1.member.member_8.member;
let _e639 = global_1.member.member_7.member_2;
let _e641 = ((_e628 + (_e632 * _e624)) + (((_e611 - _e600) + 0.5f) * _e639));
let _e645 = global_1.member.member_7.member_1;
let _e649 = global_1.member.member_8.member_1;
let _e654 = ((_e645 + (_e649 * _e624)) + (((_e613 - _e609) + 0.5f) * _e639));
let _e658 = global_1.member.member_4.member_1;
let _e659 = (_e658 - _e623);
let _e664 = ((_e628 + (_e632 * _e659)) + ((_e611 + 0.5f) * _e639));
let _e669 = ((_e645 + (_e649 * _e659)) + ((_e613 + 0.5f) * _e639));
let _e673 = global_1.member.member_5.member;
let _e686 = global_1.member.member_5.member.member_3;
let _e687 = ((((_e673.member * _e641) + (_e673.member_1 * _e654)) + (_e673.member_2 * _e619)) + _e686);
let _e691 = global_1.member.member_5.member_1;
let _e704 = global_1.member.member_5.member_1.member_3;
let _e705 = ((((_e691.member * _e641) + (_e691.member_1 * _e654)) + (_e691.member_2 * _e619)) + _e704);
let _e709 = global_1.member.member_5.member_2;
let _e722 = global_1.member.member_5.member_2.member_3;
let _e723 = ((((_e709.member * _e641) + (_e709.member_1 * _e654)) + (_e709.member_2 * _e619)) + _e722);
let _e729 = ((((_e673.member * _e664) + (_e673.member_1 * _e669)) + (_e673.member_2 * _e658)) + _e686);
let _e735 = ((((_e691.member * _e664) + (_e691.member_1 * _e669)) + (_e691.member_2 * _e658)) + _e704);
let _e741 = ((((_e709.member * _e664) + (_e709.member_1 * _e669)) + (_e709.member_2 * _e658)) + _e722);
let _e743 = (_e586 == 2u);
let _e746 = (((_e586 == 1u) || _e743) || (_e586 == 5u));
if _e746 {
let _e1133 = global_1.member.member_5.member_3.member;
let _e1134 = (_e1133 - 0.5f);
let _e1136 = select(-0.5f, _e729, (_e729 > -0.5f));
let _e1138 = select(_e1134, _e1136, (_e1136 < _e1134));
let _e1143 = global_1.member.member_5.member_3.member_1;
let _e1144 = (_e1143 - 0.5f);
let _e1146 = select(-0.5f, _e735, (_e735 > -0.5f));
let _e1148 = select(_e1144, _e1146, (_e1146 < _e1144));
let _e1153 = global_1.member.member_5.member_3.member_2;
let _e1154 = (_e1153 - 0.5f);
let _e1156 = select(-0.5f, _e741, (_e741 > -0.5f));
let _e1158 = select(_e1154, _e1156, (_e1156 < _e1154));
let _e1160 = select(-1f, _e1138, (_e1138 > -1f));
let _e1162 = select(_e1133, _e1160, (_e1160 < _e1133));
let _e1169 = select(0i, select(select(i32(_e1162), i32(-2147483648), (_e1162 < -2147483600f)), 2147483647i, (_e1162 > 2147483500f)), (_e1162 == _e1162));
let _e1173 = (_e1169 - select(0i, 1i, (_e1162 < f32(_e1169))));
let _e1175 = select(-1f, _e1148, (_e1148 > -1f));
let _e1177 = select(_e1143, _e1175, (_e1175 < _e1143));
let _e1184 = select(0i, select(select(i32(_e1177), i32(-2147483648), (_e1177 < -2147483600f)), 2147483647i, (_e1177 > 2147483500f)), (_e1177 == _e1177));
let _e1188 = (_e1184 - select(0i, 1i, (_e1177 < f32(_e1184))));
let _e1190 = select(-1f, _e1158, (_e1158 > -1f));
let _e1192 = select(_e1153, _e1190, (_e1190 < _e1153));
let _e1199 = select(0i, select(select(i32(_e1192), i32(-2147483648), (_e1192 < -2147483600f)), 2147483647i, (_e1192 > 2147483500f)), (_e1192 == _e1192));
let _e1203 = (_e1199 - select(0i, 1i, (_e1192 < f32(_e1199))));
let _e1208 = global_1.member.member_5.member_5[0u];
let _e1213 = global_1.member.member_5.member_5[1u];
let _e1214 = (_e1173 + 1i);
let _e1215 = (_e1188 + 1i);
let _e1216 = (_e1203 + 1i);
let _e1223 = global_1.member.member_5.member_7[0u];
let _e1230 = global_1.member.member_5.member_7[1u];
let _e1236 = ((_e1214 >> bitcast<u32>(4i)) + (_e1223 * ((_e1215 >> bitcast<u32>(4i)) + (_e1230 * (_e1216 >> bitcast<u32>(4i))))));
let _e1238 = (bitcast<i32>(_e91) - 1i);
let _e1240 = select(_e1238, _e1236, (_e1236 < _e1238));
let _e1246 = global_2.member[bitcast<u32>(select(0i, _e1240, (_e1240 > 0i)))];
let _e1248 = (_e1214 & 15i);
let _e1251 = ((_e1215 & 15i) * _e1208);
let _e1253 = (bitcast<i32>(_e1246) + ((_e1216 & 15i) * _e1213));
let _e1254 = (_e1251 + _e1208);
let _e1256 = (_e1251 + (2i * _e1208));
let _e1258 = (_e1251 + (3i * _e1208));
let _e1259 = (_e1253 + _e1213);
let _e1261 = (_e1253 + (2i * _e1213));
let _e1263 = (_e1253 + (3i * _e1213));
local_4 = type_18(array<i32, 4>(_e1248, _e1248, _e1248, _e1248), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_5 = vec3<f32>((_e1138 - f32(_e1173)), (_e1148 - f32(_e1188)), (_e1158 - f32(_e1203)));
let _e1277 = local_4.member[0u];
let _e1278 = ((_e1259 + _e1254) + _e1277);
let _e1280 = (_e1278 >> bitcast<u32>(2i));
let _e1283 = bitcast<u32>(((_e1278 & 3i) * 8i));
let _e1285 = select(_e1238, _e1280, (_e1280 < _e1238));
let _e1290 = global_2.member[bitcast<u32>(select(0i, _e1285, (_e1285 > 0i)))];
let _e1294 = (_e1280 + 1i);
let _e1296 = select(_e1238, _e1294, (_e1294 < _e1238));
let _e1301 = global_2.member[bitcast<u32>(select(0i, _e1296, (_e1296 > 0i)))];
let _e1308 = ((_e1290 >> bitcast<u32>((_e1283 & 31u))) | ((_e1301 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1283) & 31u))));
let _e1311 = local_4.member_1[0u];
let _e1317 = f32(bitcast<i32>(((_e1308 >> bitcast<u32>((_e1311 & 31u))) & 255u)));
let _e1320 = local_4.member_1[1u];
let _e1326 = f32(bitcast<i32>(((_e1308 >> bitcast<u32>((_e1320 & 31u))) & 255u)));
let _e1329 = local_4.member_1[2u];
let _e1335 = f32(bitcast<i32>(((_e1308 >> bitcast<u32>((_e1329 & 31u))) & 255u)));
let _e1338 = local_4.member_1[3u];
let _e1345 = local_5[0u];
let _e1348 = (_e1317 + ((_e1326 - _e1317) * _e1345));
let _e1349 = local_5[0u];
let _e1352 = (_e1326 + ((_e1335 - _e1326) * _e1349));
let _e1353 = local_5[0u];
let _e1356 = (_e1335 + ((f32(bitcast<i32>(((_e1308 >> bitcast<u32>((_e1338 & 31u))) & 255u))) - _e1335) * _e1353));
let _e1358 = local_4.member[0u];
let _e1359 = ((_e1259 + _e1256) + _e1358);
let _e1361 = (_e1359 >> bitcast<u32>(2i));
let _e1364 = bitcast<u32>(((_e1359 & 3i) * 8i));
let _e1366 = select(_e1238, _e1361, (_e1361 < _e1238));
let _e1371 = global_2.member[bitcast<u32>(select(0i, _e1366, (_e1366 > 0i)))];
let _e1375 = (_e1361 + 1i);
let _e1377 = select(_e1238, _e1375, (_e1375 < _e1238));
let _e1382 = global_2.member[bitcast<u32>(select(0i, _e1377, (_e1377 > 0i)))];
let _e1389 = ((_e1371 >> bitcast<u32>((_e1364 & 31u))) | ((_e1382 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1364) & 31u))));
let _e1390 = local_4.member_1[0u];
let _e1396 = f32(bitcast<i32>(((_e1389 >> bitcast<u32>((_e1390 & 31u))) & 255u)));
let _e1397 = local_4.member_1[1u];
let _e1403 = f32(bitcast<i32>(((_e1389 >> bitcast<u32>((_e1397 & 31u))) & 255u)));
let _e1404 = local_4.member_1[2u];
let _e1410 = f32(bitcast<i32>(((_e1389 >> bitcast<u32>((_e1404 & 31u))) & 255u)));
let _e1411 = local_4.member_1[3u];
let _e1418 = local_5[0u];
let _e1422 = local_5[0u];
let _e1425 = (_e1403 + ((_e1410 - _e1403) * _e1422));
let _e1426 = local_5[0u];
let _e1431 = local_4.member[0u];
let _e1432 = ((_e1261 + _e1254) + _e1431);
let _e1434 = (_e1432 >> bitcast<u32>(2i));
let _e1437 = bitcast<u32>(((_e1432 & 3i) * 8i));
let _e1439 = select(_e1238, _e1434, (_e1434 < _e1238));
let _e1444 = global_2.member[bitcast<u32>(select(0i, _e1439, (_e1439 > 0i)))];
let _e1448 = (_e1434 + 1i);
let _e1450 = select(_e1238, _e1448, (_e1448 < _e1238));
let _e1455 = global_2.member[bitcast<u32>(select(0i, _e1450, (_e1450 > 0i)))];
let _e1462 = ((_e1444 >> bitcast<u32>((_e1437 & 31u))) | ((_e1455 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1437) & 31u))));
let _e1463 = local_4.member_1[0u];
let _e1469 = f32(bitcast<i32>(((_e1462 >> bitcast<u32>((_e1463 & 31u))) & 255u)));
let _e1470 = local_4.member_1[1u];
let _e1476 = f32(bitcast<i32>(((_e1462 >> bitcast<u32>((_e1470 & 31u))) & 255u)));
let _e1477 = local_4.member_1[2u];
let _e1483 = f32(bitcast<i32>(((_e1462 >> bitcast<u32>((_e1477 & 31u))) & 255u)));
let _e1484 = local_4.member_1[3u];
let _e1491 = local_5[0u];
let _e1494 = (_e1469 + ((_e1476 - _e1469) * _e1491));
let _e1495 = local_5[0u];
let _e1498 = (_e1476 + ((_e1483 - _e1476) * _e1495));
let _e1499 = local_5[0u];
let _e1502 = (_e1483 + ((f32(bitcast<i32>(((_e1462 >> bitcast<u32>((_e1484 & 31u))) & 255u))) - _e1483) * _e1499));
let _e1504 = local_4.member[0u];
let _e1505 = ((_e1261 + _e1256) + _e1504);
let _e1507 = (_e1505 >> bitcast<u32>(2i));
let _e1510 = bitcast<u32>(((_e1505 & 3i) * 8i));
let _e1512 = select(_e1238, _e1507, (_e1507 < _e1238));
let _e1517 = global_2.member[bitcast<u32>(select(0i, _e1512, (_e1512 > 0i)))];
let _e1521 = (_e1507 + 1i);
let _e1523 = select(_e1238, _e1521, (_e1521 < _e1238));
let _e1528 = global_2.member[bitcast<u32>(select(0i, _e1523, (_e1523 > 0i)))];
let _e1535 = ((_e1517 >> bitcast<u32>((_e1510 & 31u))) | ((_e1528 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1510) & 31u))));
let _e1536 = local_4.member_1[0u];
let _e1542 = f32(bitcast<i32>(((_e1535 >> bitcast<u32>((_e1536 & 31u))) & 255u)));
let _e1543 = local_4.member_1[1u];
let _e1549 = f32(bitcast<i32>(((_e1535 >> bitcast<u32>((_e1543 & 31u))) & 255u)));
let _e1550 = local_4.member_1[2u];
let _e1556 = f32(bitcast<i32>(((_e1535 >> bitcast<u32>((_e1550 & 31u))) & 255u)));
let _e1557 = local_4.member_1[3u];
let _e1564 = local_5[0u];
let _e1568 = local_5[0u];
let _e1571 = (_e1549 + ((_e1556 - _e1549) * _e1568));
let _e1572 = local_5[0u];
let _e1577 = local_4.member[0u];
let _e1578 = ((_e1259 + _e1251) + _e1577);
let _e1580 = (_e1578 >> bitcast<u32>(2i));
let _e1583 = bitcast<u32>(((_e1578 & 3i) * 8i));
let _e1585 = select(_e1238, _e1580, (_e1580 < _e1238));
let _e1590 = global_2.member[bitcast<u32>(select(0i, _e1585, (_e1585 > 0i)))];
let _e1594 = (_e1580 + 1i);
let _e1596 = select(_e1238, _e1594, (_e1594 < _e1238));
let _e1601 = global_2.member[bitcast<u32>(select(0i, _e1596, (_e1596 > 0i)))];
let _e1608 = ((_e1590 >> bitcast<u32>((_e1583 & 31u))) | ((_e1601 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1583) & 31u))));
let _e1609 = local_4.member_1[1u];
let _e1615 = f32(bitcast<i32>(((_e1608 >> bitcast<u32>((_e1609 & 31u))) & 255u)));
let _e1616 = local_4.member_1[2u];
let _e1623 = local_5[0u];
let _e1626 = (_e1615 + ((f32(bitcast<i32>(((_e1608 >> bitcast<u32>((_e1616 & 31u))) & 255u))) - _e1615) * _e1623));
let _e1628 = local_4.member[0u];
let _e1629 = ((_e1259 + _e1258) + _e1628);
let _e1631 = (_e1629 >> bitcast<u32>(2i));
let _e1634 = bitcast<u32>(((_e1629 & 3i) * 8i));
let _e1636 = select(_e1238, _e1631, (_e1631 < _e1238));
let _e1641 = global_2.member[bitcast<u32>(select(0i, _e1636, (_e1636 > 0i)))];
let _e1645 = (_e1631 + 1i);
let _e1647 = select(_e1238, _e1645, (_e1645 < _e1238));
let _e1652 = global_2.member[bitcast<u32>(select(0i, _e1647, (_e1647 > 0i)))];
let _e1659 = ((_e1641 >> bitcast<u32>((_e1634 & 31u))) | ((_e1652 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1634) & 31u))));
let _e1660 = local_4.member_1[1u];
let _e1666 = f32(bitcast<i32>(((_e1659 >> bitcast<u32>((_e1660 & 31u))) & 255u)));
let _e1667 = local_4.member_1[2u];
let _e1674 = local_5[0u];
let _e1679 = local_4.member[0u];
let _e1680 = ((_e1261 + _e1251) + _e1679);
let _e1682 = (_e1680 >> bitcast<u32>(2i));
let _e1685 = bitcast<u32>(((_e1680 & 3i) * 8i));
let _e1687 = select(_e1238, _e1682, (_e1682 < _e1238));
let _e1692 = global_2.member[bitcast<u32>(select(0i, _e1687, (_e1687 > 0i)))];
let _e1696 = (_e1682 + 1i);
let _e1698 = select(_e1238, _e1696, (_e1696 < _e1238));
let _e1703 = global_2.member[bitcast<u32>(select(0i, _e1698, (_e1698 > 0i)))];
let _e1710 = ((_e1692 >> bitcast<u32>((_e1685 & 31u))) | ((_e1703 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1685) & 31u))));
let _e1711 = local_4.member_1[1u];
let _e1717 = f32(bitcast<i32>(((_e1710 >> bitcast<u32>((_e1711 & 31u))) & 255u)));
let _e1718 = local_4.member_1[2u];
let _e1725 = local_5[0u];
let _e1728 = (_e1717 + ((f32(bitcast<i32>(((_e1710 >> bitcast<u32>((_e1718 & 31u))) & 255u))) - _e1717) * _e1725));
let _e1730 = local_4.member[0u];
let _e1731 = ((_e1261 + _e1258) + _e1730);
let _e1733 = (_e1731 >> bitcast<u32>(2i));
let _e1736 = bitcast<u32>(((_e1731 & 3i) * 8i));
let _e1738 = select(_e1238, _e1733, (_e1733 < _e1238));
let _e1743 = global_2.member[bitcast<u32>(select(0i, _e1738, (_e1738 > 0i)))];
let _e1747 = (_e1733 + 1i);
let _e1749 = select(_e1238, _e1747, (_e1747 < _e1238));
let _e1754 = global_2.member[bitcast<u32>(select(0i, _e1749, (_e1749 > 0i)))];
let _e1761 = ((_e1743 >> bitcast<u32>((_e1736 & 31u))) | ((_e1754 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1736) & 31u))));
let _e1762 = local_4.member_1[1u];
let _e1768 = f32(bitcast<i32>(((_e1761 >> bitcast<u32>((_e1762 & 31u))) & 255u)));
let _e1769 = local_4.member_1[2u];
let _e1776 = local_5[0u];
let _e1781 = local_4.member[0u];
let _e1782 = ((_e1253 + _e1254) + _e1781);
let _e1784 = (_e1782 >> bitcast<u32>(2i));
let _e1787 = bitcast<u32>(((_e1782 & 3i) * 8i));
let _e1789 = select(_e1238, _e1784, (_e1784 < _e1238));
let _e1794 = global_2.member[bitcast<u32>(select(0i, _e1789, (_e1789 > 0i)))];
let _e1798 = (_e1784 + 1i);
let _e1800 = select(_e1238, _e1798, (_e1798 < _e1238));
let _e1805 = global_2.member[bitcast<u32>(select(0i, _e1800, (_e1800 > 0i)))];
let _e1812 = ((_e1794 >> bitcast<u32>((_e1787 & 31u))) | ((_e1805 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1787) & 31u))));
let _e1813 = local_4.member_1[1u];
let _e1819 = f32(bitcast<i32>(((_e1812 >> bitcast<u32>((_e1813 & 31u))) & 255u)));
let _e1820 = local_4.member_1[2u];
let _e1827 = local_5[0u];
let _e1830 = (_e1819 + ((f32(bitcast<i32>(((_e1812 >> bitcast<u32>((_e1820 & 31u))) & 255u))) - _e1819) * _e1827));
let _e1832 = local_4.member[0u];
let _e1833 = ((_e1263 + _e1254) + _e1832);
let _e1835 = (_e1833 >> bitcast<u32>(2i));
let _e1838 = bitcast<u32>(((_e1833 & 3i) * 8i));
let _e1840 = select(_e1238, _e1835, (_e1835 < _e1238));
let _e1845 = global_2.member[bitcast<u32>(select(0i, _e1840, (_e1840 > 0i)))];
let _e1849 = (_e1835 + 1i);
let _e1851 = select(_e1238, _e1849, (_e1849 < _e1238));
let _e1856 = global_2.member[bitcast<u32>(select(0i, _e1851, (_e1851 > 0i)))];
let _e1863 = ((_e1845 >> bitcast<u32>((_e1838 & 31u))) | ((_e1856 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1838) & 31u))));
let _e1864 = local_4.member_1[1u];
let _e1870 = f32(bitcast<i32>(((_e1863 >> bitcast<u32>((_e1864 & 31u))) & 255u)));
let _e1871 = local_4.member_1[2u];
let _e1878 = local_5[0u];
let _e1881 = (_e1870 + ((f32(bitcast<i32>(((_e1863 >> bitcast<u32>((_e1871 & 31u))) & 255u))) - _e1870) * _e1878));
let _e1883 = local_4.member[0u];
let _e1884 = ((_e1253 + _e1256) + _e1883);
let _e1886 = (_e1884 >> bitcast<u32>(2i));
let _e1889 = bitcast<u32>(((_e1884 & 3i) * 8i));
let _e1891 = select(_e1238, _e1886, (_e1886 < _e1238));
let _e1896 = global_2.member[bitcast<u32>(select(0i, _e1891, (_e1891 > 0i)))];
let _e1900 = (_e1886 + 1i);
let _e1902 = select(_e1238, _e1900, (_e1900 < _e1238));
let _e1907 = global_2.member[bitcast<u32>(select(0i, _e1902, (_e1902 > 0i)))];
let _e1914 = ((_e1896 >> bitcast<u32>((_e1889 & 31u))) | ((_e1907 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1889) & 31u))));
let _e1915 = local_4.member_1[1u];
let _e1921 = f32(bitcast<i32>(((_e1914 >> bitcast<u32>((_e1915 & 31u))) & 255u)));
let _e1922 = local_4.member_1[2u];
let _e1929 = local_5[0u];
let _e1934 = local_4.member[0u];
let _e1935 = ((_e1263 + _e1256) + _e1934);
let _e1937 = (_e1935 >> bitcast<u32>(2i));
let _e1940 = bitcast<u32>(((_e1935 & 3i) * 8i));
let _e1942 = select(_e1238, _e1937, (_e1937 < _e1238));
let _e1947 = global_2.member[bitcast<u32>(select(0i, _e1942, (_e1942 > 0i)))];
let _e1951 = (_e1937 + 1i);
let _e1953 = select(_e1238, _e1951, (_e1951 < _e1238));
let _e1958 = global_2.member[bitcast<u32>(select(0i, _e1953, (_e1953 > 0i)))];
let _e1965 = ((_e1947 >> bitcast<u32>((_e1940 & 31u))) | ((_e1958 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1940) & 31u))));
let _e1966 = local_4.member_1[1u];
let _e1972 = f32(bitcast<i32>(((_e1965 >> bitcast<u32>((_e1966 & 31u))) & 255u)));
let _e1973 = local_4.member_1[2u];
let _e1980 = local_5[0u];
let _e1985 = local_5[1u];
let _e1988 = (_e1352 + ((_e1425 - _e1352) * _e1985));
let _e1989 = local_5[1u];
let _e1992 = (_e1498 + ((_e1571 - _e1498) * _e1989));
let _e1993 = local_5[1u];
let _e1996 = (_e1348 + (((_e1396 + ((_e1403 - _e1396) * _e1418)) - _e1348) * _e1993));
let _e1997 = local_5[1u];
let _e2002 = local_5[2u];
let _e2006 = local_5[1u];
let _e2009 = (_e1356 + (((_e1410 + ((f32(bitcast<i32>(((_e1389 >> bitcast<u32>((_e1411 & 31u))) & 255u))) - _e1410) * _e1426)) - _e1356) * _e2006));
let _e2010 = local_5[1u];
let _e2014 = local_5[2u];
let _e2018 = local_5[1u];
let _e2021 = (_e1626 + ((_e1352 - _e1626) * _e2018));
let _e2022 = local_5[1u];
let _e2026 = local_5[2u];
let _e2030 = local_5[1u];
let _e2033 = (_e1425 + (((_e1666 + ((f32(bitcast<i32>(((_e1659 >> bitcast<u32>((_e1667 & 31u))) & 255u))) - _e1666) * _e1674)) - _e1425) * _e2030));
let _e2034 = local_5[1u];
let _e2038 = local_5[2u];
let _e2042 = local_5[1u];
let _e2045 = (_e1830 + (((_e1921 + ((f32(bitcast<i32>(((_e1914 >> bitcast<u32>((_e1922 & 31u))) & 255u))) - _e1921) * _e1929)) - _e1830) * _e2042));
let _e2046 = local_5[2u];
let _e2050 = local_5[1u];
let _e2054 = local_5[2u];
let _e2058 = local_5[2u];
let _e2066 = global_1.member.member_5.member_4.member;
let _e2072 = global_1.member.member_5.member_4.member_1;
let _e2073 = (((_e1988 + ((_e1992 - _e1988) * _e2058)) * _e2066) + _e2072);
let _e2075 = select(0f, _e2073, (_e2073 > 0f));
let _e2077 = select(1f, _e2075, (_e2075 < 1f));
let _e2079 = (((_e1996 + (((_e1494 + (((_e1542 + ((_e1549 - _e1542) * _e1564)) - _e1494) * _e1997)) - _e1996) * _e2002)) * _e2066) + _e2072);
let _e2081 = select(0f, _e2079, (_e2079 > 0f));
let _e2083 = select(1f, _e2081, (_e2081 < 1f));
let _e2085 = (((_e2009 + (((_e1502 + (((_e1556 + ((f32(bitcast<i32>(((_e1535 >> bitcast<u32>((_e1557 & 31u))) & 255u))) - _e1556) * _e1572)) - _e1502) * _e2010)) - _e2009) * _e2014)) * _e2066) + _e2072);
let _e2087 = select(0f, _e2085, (_e2085 > 0f));
let _e2089 = select(1f, _e2087, (_e2087 < 1f));
let _e2091 = (((_e2021 + (((_e1728 + ((_e1498 - _e1728) * _e2022)) - _e2021) * _e2026)) * _e2066) + _e2072);
let _e2093 = select(0f, _e2091, (_e2091 > 0f));
let _e2095 = select(1f, _e2093, (_e2093 < 1f));
let _e2097 = (((_e2033 + (((_e1571 + (((_e1768 + ((f32(bitcast<i32>(((_e1761 >> bitcast<u32>((_e1769 & 31u))) & 255u))) - _e1768) * _e1776)) - _e1571) * _e2034)) - _e2033) * _e2038)) * _e2066) + _e2072);
let _e2099 = select(0f, _e2097, (_e2097 > 0f));
let _e2101 = select(1f, _e2099, (_e2099 < 1f));
let _e2103 = (((_e2045 + ((_e1988 - _e2045) * _e2046)) * _e2066) + _e2072);
let _e2105 = select(0f, _e2103, (_e2103 > 0f));
let _e2107 = select(1f, _e2105, (_e2105 < 1f));
let _e2109 = (((_e1992 + (((_e1881 + (((_e1972 + ((f32(bitcast<i32>(((_e1965 >> bitcast<u32>((_e1973 & 31u))) & 255u))) - _e1972) * _e1980)) - _e1881) * _e2050)) - _e1992) * _e2054)) * _e2066) + _e2072);
let _e2111 = select(0f, _e2109, (_e2109 > 0f));
let _e2113 = select(1f, _e2111, (_e2111 < 1f));
let _e2114 = (_e2077 * 1024f);
let _e2115 = (1024f - 1f);
let _e2117 = select(0f, _e2114, (_e2114 > 0f));
let _e2119 = select(_e2115, _e2117, (_e2117 < _e2115));
let _e2126 = select(0i, select(select(i32(_e2119), i32(-2147483648), (_e2119 < -2147483600f)), 2147483647i, (_e2119 > 2147483500f)), (_e2119 == _e2119));
let _e2130 = (_e2126 - select(0i, 1i, (_e2119 < f32(_e2126))));
let _e2131 = (262147i + _e2130);
let _e2133 = (bitcast<i32>(_e95) - 1i);
let _e2135 = select(_e2133, _e2131, (_e2131 < _e2133));
let _e2141 = global_4.member[bitcast<u32>(select(0i, _e2135, (_e2135 > 0i)))];
let _e2151 = select(_e2133, 262146i, (262146i < _e2133));
let _e2157 = global_4.member[bitcast<u32>(select(0i, _e2151, (_e2151 > 0i)))];
let _e2158 = bitcast<f32>(_e2157);
let _e2159 = (f32((bitcast<i32>((_e2141 & 4095u)) - 2048i)) * _e2158);
let _e2161 = select(_e2133, 262144i, (262144i < _e2133));
let _e2167 = global_4.member[bitcast<u32>(select(0i, _e2161, (_e2161 > 0i)))];
let _e2168 = bitcast<f32>(_e2167);
let _e2170 = select(_e2133, 262145i, (262145i < _e2133));
let _e2176 = global_4.member[bitcast<u32>(select(0i, _e2170, (_e2170 > 0i)))];
let _e2177 = bitcast<f32>(_e2176);
let _e2183 = ((_e2168 + (f32(bitcast<i32>((_e2141 >> bitcast<u32>(12u)))) * _e2177)) + (_e2159 * (_e2114 - f32(_e2130))));
let _e2184 = (_e2159 * 1024f);
if _e743 {
let _e2449 = ((0.5f * (_e2089 - _e2083)) * _e2184);
let _e2450 = ((0.5f * (_e2101 - _e2095)) * _e2184);
let _e2451 = ((0.5f * (_e2113 - _e2107)) * _e2184);
phi_5328_ = type_19(_e2183, vec3<f32>(_e2449, _e2450, _e2451), vec3<f32>((_e2449 * _e2183), (_e2450 * _e2183), (_e2451 * _e2183)));
} else {
let _e2185 = (_e2083 * 1024f);
let _e2187 = select(0f, _e2185, (_e2185 > 0f));
let _e2189 = select(_e2115, _e2187, (_e2187 < _e2115));
let _e2196 = select(0i, select(select(i32(_e2189), i32(-2147483648), (_e2189 < -2147483600f)), 2147483647i, (_e2189 > 2147483500f)), (_e2189 == _e2189));
let _e2200 = (_e2196 - select(0i, 1i, (_e2189 < f32(_e2196))));
let _e2201 = (262147i + _e2200);
let _e2203 = select(_e2133, _e2201, (_e2201 < _e2133));
let _e2209 = global_4.member[bitcast<u32>(select(0i, _e2203, (_e2203 > 0i)))];
let _e2224 = ((_e2168 + (f32(bitcast<i32>((_e2209 >> bitcast<u32>(12u)))) * _e2177)) + ((f32((bitcast<i32>((_e2209 & 4095u)) - 2048i)) * _e2158) * (_e2185 - f32(_e2200))));
let _e2225 = (_e2089 * 1024f);
let _e2227 = select(0f, _e2225, (_e2225 > 0f));
let _e2229 = select(_e2115, _e2227, (_e2227 < _e2115));
let _e2236 = select(0i, select(select(i32(_e2229), i32(-2147483648), (_e2229 < -2147483600f)), 2147483647i, (_e2229 > 2147483500f)), (_e2229 == _e2229));
let _e2240 = (_e2236 - select(0i, 1i, (_e2229 < f32(_e2236))));
let _e2241 = (262147i + _e2240);
let _e2243 = select(_e2133, _e2241, (_e2241 < _e2133));
let _e2249 = global_4.member[bitcast<u32>(select(0i, _e2243, (_e2243 > 0i)))];
let _e2264 = ((_e2168 + (f32(bitcast<i32>((_e2249 >> bitcast<u32>(12u)))) * _e2177)) + ((f32((bitcast<i32>((_e2249 & 4095u)) - 2048i)) * _e2158) * (_e2225 - f32(_e2240))));
let _e2265 = (_e2095 * 1024f);
let _e2267 = select(0f, _e2265, (_e2265 > 0f));
let _e2269 = select(_e2115, _e2267, (_e2267 < _e2115));
let _e2276 = select(0i, select(select(i32(_e2269), i32(-2147483648), (_e2269 < -2147483600f)), 2147483647i, (_e2269 > 2147483500f)), (_e2269 == _e2269));
let _e2280 = (_e2276 - select(0i, 1i, (_e2269 < f32(_e2276))));
let _e2281 = (262147i + _e2280);
let _e2283 = select(_e2133, _e2281, (_e2281 < _e2133));
let _e2289 = global_4.member[bitcast<u32>(select(0i, _e2283, (_e2283 > 0i)))];
let _e2304 = ((_e2168 + (f32(bitcast<i32>((_e2289 >> bitcast<u32>(12u)))) * _e2177)) + ((f32((bitcast<i32>((_e2289 & 4095u)) - 2048i)) * _e2158) * (_e2265 - f32(_e2280))));
let _e2305 = (_e2101 * 1024f);
let _e2307 = select(0f, _e2305, (_e2305 > 0f));
let _e2309 = select(_e2115, _e2307, (_e2307 < _e2115));
let _e2316 = select(0i, select(select(i32(_e2309), i32(-2147483648), (_e2309 < -2147483600f)), 2147483647i, (_e2309 > 2147483500f)), (_e2309 == _e2309));
let _e2320 = (_e2316 - select(0i, 1i, (_e2309 < f32(_e2316))));
let _e2321 = (262147i + _e2320);
let _e2323 = select(_e2133, _e2321, (_e2321 < _e2133));
let _e2329 = global_4.member[bitcast<u32>(select(0i, _e2323, (_e2323 > 0i)))];
let _e2344 = ((_e2168 + (f32(bitcast<i32>((_e2329 >> bitcast<u32>(12u)))) * _e2177)) + ((f32((bitcast<i32>((_e2329 & 4095u)) - 2048i)) * _e2158) * (_e2305 - f32(_e2320))));
let _e2345 = (_e2107 * 1024f);
let _e2347 = select(0f, _e2345, (_e2345 > 0f));
let _e2349 = select(_e2115, _e2347, (_e2347 < _e2115));
let _e2356 = select(0i, select(select(i32(_e2349), i32(-2147483648), (_e2349 < -2147483600f)), 2147483647i, (_e2349 > 2147483500f)), (_e2349 == _e2349));
let _e2360 = (_e2356 - select(0i, 1i, (_e2349 < f32(_e2356))));
let _e2361 = (262147i + _e2360);
let _e2363 = select(_e2133, _e2361, (_e2361 < _e2133));
let _e2369 = global_4.member[bitcast<u32>(select(0i, _e2363, (_e2363 > 0i)))];
let _e2384 = ((_e2168 + (f32(bitcast<i32>((_e2369 >> bitcast<u32>(12u)))) * _e2177)) + ((f32((bitcast<i32>((_e2369 & 4095u)) - 2048i)) * _e2158) * (_e2345 - f32(_e2360))));
let _e2385 = (_e2113 * 1024f);
let _e2387 = select(0f, _e2385, (_e2385 > 0f));
let _e2389 = select(_e2115, _e2387, (_e2387 < _e2115));
let _e2396 = select(0i, select(select(i32(_e2389), i32(-2147483648), (_e2389 < -2147483600f)), 2147483647i, (_e2389 > 2147483500f)), (_e2389 == _e2389));
let _e2400 = (_e2396 - select(0i, 1i, (_e2389 < f32(_e2396))));
let _e2401 = (262147i + _e2400);
let _e2403 = select(_e2133, _e2401, (_e2401 < _e2133));
let _e2409 = global_4.member[bitcast<u32>(select(0i, _e2403, (_e2403 > 0i)))];
let _e2424 = ((_e2168 + (f32(bitcast<i32>((_e2409 >> bitcast<u32>(12u)))) * _e2177)) + ((f32((bitcast<i32>((_e2409 & 4095u)) - 2048i)) * _e2158) * (_e2385 - f32(_e2400))));
let _e2425 = (_e2264 - _e2224);
let _e2427 = (_e2344 - _e2304);
let _e2429 = (_e2424 - _e2384);
phi_5328_ = type_19(_e2183, vec3<f32>((0.5f * _e2425), (0.5f * _e2427), (0.5f * _e2429)), vec3<f32>((0.25f * (_e2425 * (_e2264 + _e2224))), (0.25f * (_e2427 * (_e2344 + _e2304))), (0.25f * (_e2429 * (_e2424 + _e2384)))));
}
let _e2459 = phi_5328_;
let _e2474 = select(0f, 1f, ((((((_e729 >= -0.5f) && (_e729 <= _e1134)) && (_e735 >= -0.5f)) && (_e735 <= _e1144)) && (_e741 >= -0.5f)) && (_e741 <= _e1154)));
let _e2476 = (0.5f * (_e2089 - _e2083));
let _e2478 = (0.5f * (_e2101 - _e2095));
let _e2480 = (0.5f * (_e2113 - _e2107));
let _e2485 = global_1.member.member_5.member.member;
let _e2491 = global_1.member.member_5.member_1.member;
let _e2498 = global_1.member.member_5.member_2.member;
let _e2505 = global_1.member.member_5.member.member_1;
let _e2511 = global_1.member.member_5.member_1.member_1;
let _e2518 = global_1.member.member_5.member_2.member_1;
let _e2525 = global_1.member.member_5.member.member_2;
let _e2531 = global_1.member.member_5.member_1.member_2;
let _e2538 = global_1.member.member_5.member_2.member_2;
phi_6649_ = type_20(_e2077, vec3<f32>(((((_e2485 * _e2476) + (_e2491 * _e2478)) + (_e2498 * _e2480)) * _e2474), ((((_e2505 * _e2476) + (_e2511 * _e2478)) + (_e2518 * _e2480)) * _e2474), ((((_e2525 * _e2476) + (_e2531 * _e2478)) + (_e2538 * _e2480)) * _e2474)), _e2459.member, vec3<f32>(((((_e2485 * _e2459.member_2.x) + (_e2491 * _e2459.member_2.y)) + (_e2498 * _e2459.member_2.z)) * _e2474), ((((_e2505 * _e2459.member_2.x) + (_e2511 * _e2459.member_2.y)) + (_e2518 * _e2459.member_2.z)) * _e2474), ((((_e2525 * _e2459.member_2.x) + (_e2531 * _e2459.member_2.y)) + (_e2538 * _e2459.member_2.z)) * _e2474)), vec3<f32>(((((_e2485 * _e2459.member_1.x) + (_e2491 * _e2459.member_1.y)) + (_e2498 * _e2459.member_1.z)) * _e2474), ((((_e2505 * _e2459.member_1.x) + (_e2511 * _e2459.member_1.y)) + (_e2518 * _e2459.member_1.z)) * _e2474), ((((_e2525 * _e2459.member_1.x) + (_e2531 * _e2459.member_1.y)) + (_e2538 * _e2459.member_1.z)) * _e2474)));
} else {
let _e751 = global_1.member.member_5.member_3.member;
let _e752 = (_e751 - 0.5f);
let _e754 = select(-0.5f, _e729, (_e729 > -0.5f));
let _e756 = select(_e752, _e754, (_e754 < _e752));
let _e761 = global_1.member.member_5.member_3.member_1;
let _e762 = (_e761 - 0.5f);
let _e764 = select(-0.5f, _e735, (_e735 > -0.5f));
let _e766 = select(_e762, _e764, (_e764 < _e762));
let _e771 = global_1.member.member_5.member_3.member_2;
let _e772 = (_e771 - 0.5f);
let _e774 = select(-0.5f, _e741, (_e741 > -0.5f));
let _e776 = select(_e772, _e774, (_e774 < _e772));
let _e778 = select(-1f, _e756, (_e756 > -1f));
let _e780 = select(_e751, _e778, (_e778 < _e751));
let _e787 = select(0i, select(select(i32(_e780), i32(-2147483648), (_e780 < -2147483600f)), 2147483647i, (_e780 > 2147483500f)), (_e780 == _e780));
let _e791 = (_e787 - select(0i, 1i, (_e780 < f32(_e787))));
let _e793 = select(-1f, _e766, (_e766 > -1f));
let _e795 = select(_e761, _e793, (_e793 < _e761));
let _e802 = select(0i, select(select(i32(_e795), i32(-2147483648), (_e795 < -2147483600f)), 2147483647i, (_e795 > 2147483500f)), (_e795 == _e795));
let _e806 = (_e802 - select(0i, 1i, (_e795 < f32(_e802))));
let _e808 = select(-1f, _e776, (_e776 > -1f));
let _e810 = select(_e771, _e808, (_e808 < _e771));
let _e817 = select(0i, select(select(i32(_e810), i32(-2147483648), (_e810 < -2147483600f)), 2147483647i, (_e810 > 2147483500f)), (_e810 == _e810));
let _e821 = (_e817 - select(0i, 1i, (_e810 < f32(_e817))));
let _e826 = global_1.member.member_5.member_5[0u];
let _e831 = global_1.member.member_5.member_5[1u];
let _e832 = (_e791 + 1i);
let _e833 = (_e806 + 1i);
let _e834 = (_e821 + 1i);
let _e841 = global_1.member.member_5.member_7[0u];
let _e848 = global_1.member.member_5.member_7[1u];
let _e854 = ((_e832 >> bitcast<u32>(4i)) + (_e841 * ((_e833 >> bitcast<u32>(4i)) + (_e848 * (_e834 >> bitcast<u32>(4i))))));
let _e856 = (bitcast<i32>(_e91) - 1i);
let _e858 = select(_e856, _e854, (_e854 < _e856));
let _e864 = global_2.member[bitcast<u32>(select(0i, _e858, (_e858 > 0i)))];
let _e866 = (_e832 & 15i);
let _e869 = ((_e833 & 15i) * _e826);
let _e871 = (bitcast<i32>(_e864) + ((_e834 & 15i) * _e831));
let _e872 = (_e869 + _e826);
let _e874 = (_e869 + (2i * _e826));
let _e875 = (_e871 + _e831);
let _e877 = (_e871 + (2i * _e831));
local_2 = type_18(array<i32, 4>(_e866, _e866, _e866, _e866), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_3 = vec3<f32>((_e756 - f32(_e791)), (_e766 - f32(_e806)), (_e776 - f32(_e821)));
let _e891 = local_2.member[0u];
let _e892 = ((_e875 + _e872) + _e891);
let _e894 = (_e892 >> bitcast<u32>(2i));
let _e897 = bitcast<u32>(((_e892 & 3i) * 8i));
let _e899 = select(_e856, _e894, (_e894 < _e856));
let _e904 = global_2.member[bitcast<u32>(select(0i, _e899, (_e899 > 0i)))];
let _e908 = (_e894 + 1i);
let _e910 = select(_e856, _e908, (_e908 < _e856));
let _e915 = global_2.member[bitcast<u32>(select(0i, _e910, (_e910 > 0i)))];
let _e922 = ((_e904 >> bitcast<u32>((_e897 & 31u))) | ((_e915 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e897) & 31u))));
let _e925 = local_2.member_1[1u];
let _e931 = f32(bitcast<i32>(((_e922 >> bitcast<u32>((_e925 & 31u))) & 255u)));
let _e934 = local_2.member_1[2u];
let _e941 = local_3[0u];
let _e944 = (_e931 + ((f32(bitcast<i32>(((_e922 >> bitcast<u32>((_e934 & 31u))) & 255u))) - _e931) * _e941));
let _e946 = local_2.member[0u];
let _e947 = ((_e875 + _e874) + _e946);
let _e949 = (_e947 >> bitcast<u32>(2i));
let _e952 = bitcast<u32>(((_e947 & 3i) * 8i));
let _e954 = select(_e856, _e949, (_e949 < _e856));
let _e959 = global_2.member[bitcast<u32>(select(0i, _e954, (_e954 > 0i)))];
let _e963 = (_e949 + 1i);
let _e965 = select(_e856, _e963, (_e963 < _e856));
let _e970 = global_2.member[bitcast<u32>(select(0i, _e965, (_e965 > 0i)))];
let _e977 = ((_e959 >> bitcast<u32>((_e952 & 31u))) | ((_e970 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e952) & 31u))));
let _e978 = local_2.member_1[1u];
let _e984 = f32(bitcast<i32>(((_e977 >> bitcast<u32>((_e978 & 31u))) & 255u)));
let _e985 = local_2.member_1[2u];
let _e992 = local_3[0u];
let _e997 = local_3[1u];
let _e1000 = (_e944 + (((_e984 + ((f32(bitcast<i32>(((_e977 >> bitcast<u32>((_e985 & 31u))) & 255u))) - _e984) * _e992)) - _e944) * _e997));
let _e1002 = local_2.member[0u];
let _e1003 = ((_e877 + _e872) + _e1002);
let _e1005 = (_e1003 >> bitcast<u32>(2i));
let _e1008 = bitcast<u32>(((_e1003 & 3i) * 8i));
let _e1010 = select(_e856, _e1005, (_e1005 < _e856));
let _e1015 = global_2.member[bitcast<u32>(select(0i, _e1010, (_e1010 > 0i)))];
let _e1019 = (_e1005 + 1i);
let _e1021 = select(_e856, _e1019, (_e1019 < _e856));
let _e1026 = global_2.member[bitcast<u32>(select(0i, _e1021, (_e1021 > 0i)))];
let _e1033 = ((_e1015 >> bitcast<u32>((_e1008 & 31u))) | ((_e1026 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1008) & 31u))));
let _e1034 = local_2.member_1[1u];
let _e1040 = f32(bitcast<i32>(((_e1033 >> bitcast<u32>((_e1034 & 31u))) & 255u)));
let _e1041 = local_2.member_1[2u];
let _e1048 = local_3[0u];
let _e1051 = (_e1040 + ((f32(bitcast<i32>(((_e1033 >> bitcast<u32>((_e1041 & 31u))) & 255u))) - _e1040) * _e1048));
let _e1053 = local_2.member[0u];
let _e1054 = ((_e877 + _e874) + _e1053);
let _e1056 = (_e1054 >> bitcast<u32>(2i));
let _e1059 = bitcast<u32>(((_e1054 & 3i) * 8i));
let _e1061 = select(_e856, _e1056, (_e1056 < _e856));
let _e1066 = global_2.member[bitcast<u32>(select(0i, _e1061, (_e1061 > 0i)))];
let _e1070 = (_e1056 + 1i);
let _e1072 = select(_e856, _e1070, (_e1070 < _e856));
let _e1077 = global_2.member[bitcast<u32>(select(0i, _e1072, (_e1072 > 0i)))];
let _e1084 = ((_e1066 >> bitcast<u32>((_e1059 & 31u))) | ((_e1077 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1059) & 31u))));
let _e1085 = local_2.member_1[1u];
let _e1091 = f32(bitcast<i32>(((_e1084 >> bitcast<u32>((_e1085 & 31u))) & 255u)));
let _e1092 = local_2.member_1[2u];
let _e1099 = local_3[0u];
let _e1103 = local_3[1u];
let _e1108 = local_3[2u];
let _e1116 = global_1.member.member_5.member_4.member;
let _e1122 = global_1.member.member_5.member_4.member_1;
let _e1123 = (((_e1000 + (((_e1051 + (((_e1091 + ((f32(bitcast<i32>(((_e1084 >> bitcast<u32>((_e1092 & 31u))) & 255u))) - _e1091) * _e1099)) - _e1051) * _e1103)) - _e1000) * _e1108)) * _e1116) + _e1122);
let _e1125 = select(0f, _e1123, (_e1123 > 0f));
phi_6649_ = type_20(select(1f, _e1125, (_e1125 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2591 = phi_6649_;
let _e2596 = global_1.member.member_5.member_3.member;
let _e2597 = (_e2596 - 0.5f);
let _e2599 = select(-0.5f, _e687, (_e687 > -0.5f));
let _e2601 = select(_e2597, _e2599, (_e2599 < _e2597));
let _e2606 = global_1.member.member_5.member_3.member_1;
let _e2607 = (_e2606 - 0.5f);
let _e2609 = select(-0.5f, _e705, (_e705 > -0.5f));
let _e2611 = select(_e2607, _e2609, (_e2609 < _e2607));
let _e2616 = global_1.member.member_5.member_3.member_2;
let _e2617 = (_e2616 - 0.5f);
let _e2619 = select(-0.5f, _e723, (_e723 > -0.5f));
let _e2621 = select(_e2617, _e2619, (_e2619 < _e2617));
let _e2623 = select(-1f, _e2601, (_e2601 > -1f));
let _e2625 = select(_e2596, _e2623, (_e2623 < _e2596));
let _e2632 = select(0i, select(select(i32(_e2625), i32(-2147483648), (_e2625 < -2147483600f)), 2147483647i, (_e2625 > 2147483500f)), (_e2625 == _e2625));
let _e2636 = (_e2632 - select(0i, 1i, (_e2625 < f32(_e2632))));
let _e2638 = select(-1f, _e2611, (_e2611 > -1f));
let _e2640 = select(_e2606, _e2638, (_e2638 < _e2606));
let _e2647 = select(0i, select(select(i32(_e2640), i32(-2147483648), (_e2640 < -2147483600f)), 2147483647i, (_e2640 > 2147483500f)), (_e2640 == _e2640));
let _e2651 = (_e2647 - select(0i, 1i, (_e2640 < f32(_e2647))));
let _e2653 = select(-1f, _e2621, (_e2621 > -1f));
let _e2655 = select(_e2616, _e2653, (_e2653 < _e2616));
let _e2662 = select(0i, select(select(i32(_e2655), i32(-2147483648), (_e2655 < -2147483600f)), 2147483647i, (_e2655 > 2147483500f)), (_e2655 == _e2655));
let _e2666 = (_e2662 - select(0i, 1i, (_e2655 < f32(_e2662))));
let _e2671 = global_1.member.member_5.member_5[0u];
let _e2676 = global_1.member.member_5.member_5[1u];
let _e2677 = (_e2636 + 1i);
let _e2678 = (_e2651 + 1i);
let _e2679 = (_e2666 + 1i);
let _e2686 = global_1.member.member_5.member_7[0u];
let _e2693 = global_1.member.member_5.member_7[1u];
let _e2699 = ((_e2677 >> bitcast<u32>(4i)) + (_e2686 * ((_e2678 >> bitcast<u32>(4i)) + (_e2693 * (_e2679 >> bitcast<u32>(4i))))));
let _e2701 = (bitcast<i32>(_e91) - 1i);
let _e2703 = select(_e2701, _e2699, (_e2699 < _e2701));
let _e2709 = global_2.member[bitcast<u32>(select(0i, _e2703, (_e2703 > 0i)))];
let _e2711 = (_e2677 & 15i);
let _e2714 = ((_e2678 & 15i) * _e2671);
let _e2716 = (bitcast<i32>(_e2709) + ((_e2679 & 15i) * _e2676));
let _e2717 = (_e2714 + _e2671);
let _e2719 = (_e2714 + (2i * _e2671));
let _e2720 = (_e2716 + _e2676);
let _e2722 = (_e2716 + (2i * _e2676));
local = type_18(array<i32, 4>(_e2711, _e2711, _e2711, _e2711), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_1 = vec3<f32>((_e2601 - f32(_e2636)), (_e2611 - f32(_e2651)), (_e2621 - f32(_e2666)));
let _e2736 = local.member[0u];
let _e2737 = ((_e2720 + _e2717) + _e2736);
let _e2739 = (_e2737 >> bitcast<u32>(2i));
let _e2742 = bitcast<u32>(((_e2737 & 3i) * 8i));
let _e2744 = select(_e2701, _e2739, (_e2739 < _e2701));
let _e2749 = global_2.member[bitcast<u32>(select(0i, _e2744, (_e2744 > 0i)))];
let _e2753 = (_e2739 + 1i);
let _e2755 = select(_e2701, _e2753, (_e2753 < _e2701));
let _e2760 = global_2.member[bitcast<u32>(select(0i, _e2755, (_e2755 > 0i)))];
let _e2767 = ((_e2749 >> bitcast<u32>((_e2742 & 31u))) | ((_e2760 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2742) & 31u))));
let _e2770 = local.member_1[1u];
let _e2776 = f32(bitcast<i32>(((_e2767 >> bitcast<u32>((_e2770 & 31u))) & 255u)));
let _e2779 = local.member_1[2u];
let _e2786 = local_1[0u];
let _e2789 = (_e2776 + ((f32(bitcast<i32>(((_e2767 >> bitcast<u32>((_e2779 & 31u))) & 255u))) - _e2776) * _e2786));
let _e2791 = local.member[0u];
let _e2792 = ((_e2720 + _e2719) + _e2791);
let _e2794 = (_e2792 >> bitcast<u32>(2i));
let _e2797 = bitcast<u32>(((_e2792 & 3i) * 8i));
let _e2799 = select(_e2701, _e2794, (_e2794 < _e2701));
let _e2804 = global_2.member[bitcast<u32>(select(0i, _e2799, (_e2799 > 0i)))];
let _e2808 = (_e2794 + 1i);
let _e2810 = select(_e2701, _e2808, (_e2808 < _e2701));
let _e2815 = global_2.member[bitcast<u32>(select(0i, _e2810, (_e2810 > 0i)))];
let _e2822 = ((_e2804 >> bitcast<u32>((_e2797 & 31u))) | ((_e2815 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2797) & 31u))));
let _e2823 = local.member_1[1u];
let _e2829 = f32(bitcast<i32>(((_e2822 >> bitcast<u32>((_e2823 & 31u))) & 255u)));
let _e2830 = local.member_1[2u];
let _e2837 = local_1[0u];
let _e2842 = local_1[1u];
let _e2845 = (_e2789 + (((_e2829 + ((f32(bitcast<i32>(((_e2822 >> bitcast<u32>((_e2830 & 31u))) & 255u))) - _e2829) * _e2837)) - _e2789) * _e2842));
let _e2847 = local.member[0u];
let _e2848 = ((_e2722 + _e2717) + _e2847);
let _e2850 = (_e2848 >> bitcast<u32>(2i));
let _e2853 = bitcast<u32>(((_e2848 & 3i) * 8i));
let _e2855 = select(_e2701, _e2850, (_e2850 < _e2701));
let _e2860 = global_2.member[bitcast<u32>(select(0i, _e2855, (_e2855 > 0i)))];
let _e2864 = (_e2850 + 1i);
let _e2866 = select(_e2701, _e2864, (_e2864 < _e2701));
let _e2871 = global_2.member[bitcast<u32>(select(0i, _e2866, (_e2866 > 0i)))];
let _e2878 = ((_e2860 >> bitcast<u32>((_e2853 & 31u))) | ((_e2871 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2853) & 31u))));
let _e2879 = local.member_1[1u];
let _e2885 = f32(bitcast<i32>(((_e2878 >> bitcast<u32>((_e2879 & 31u))) & 255u)));
let _e2886 = local.member_1[2u];
let _e2893 = local_1[0u];
let _e2896 = (_e2885 + ((f32(bitcast<i32>(((_e2878 >> bitcast<u32>((_e2886 & 31u))) & 255u))) - _e2885) * _e2893));
let _e2898 = local.member[0u];
let _e2899 = ((_e2722 + _e2719) + _e2898);
let _e2901 = (_e2899 >> bitcast<u32>(2i));
let _e2904 = bitcast<u32>(((_e2899 & 3i) * 8i));
let _e2906 = select(_e2701, _e2901, (_e2901 < _e2701));
let _e2911 = global_2.member[bitcast<u32>(select(0i, _e2906, (_e2906 > 0i)))];
let _e2915 = (_e2901 + 1i);
let _e2917 = select(_e2701, _e2915, (_e2915 < _e2701));
let _e2922 = global_2.member[bitcast<u32>(select(0i, _e2917, (_e2917 > 0i)))];
let _e2929 = ((_e2911 >> bitcast<u32>((_e2904 & 31u))) | ((_e2922 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2904) & 31u))));
let _e2930 = local.member_1[1u];
let _e2936 = f32(bitcast<i32>(((_e2929 >> bitcast<u32>((_e2930 & 31u))) & 255u)));
let _e2937 = local.member_1[2u];
let _e2944 = local_1[0u];
let _e2948 = local_1[1u];
let _e2953 = local_1[2u];
let _e2961 = global_1.member.member_5.member_4.member;
let _e2967 = global_1.member.member_5.member_4.member_1;
let _e2968 = (((_e2845 + (((_e2896 + (((_e2936 + ((f32(bitcast<i32>(((_e2929 >> bitcast<u32>((_e2937 & 31u))) & 255u))) - _e2936) * _e2944)) - _e2896) * _e2948)) - _e2845) * _e2953)) * _e2961) + _e2967);
let _e2970 = select(0f, _e2968, (_e2968 > 0f));
let _e2972 = select(1f, _e2970, (_e2970 < 1f));
let _e2976 = global_1.member.member[3u];
if ((_e2976 & 16u) == 0u) {
phi_8135_ = type_21(1f, 1f, 1f);
} else {
let _e2981 = global_1.member.member_18;
let _e2985 = global_1.member.member_22.member;
let _e2995 = ((((_e2981.member * _e641) + (_e2981.member_1 * _e654)) + (_e2981.member_2 * _e619)) + _e2981.member_3);
let _e3001 = ((((_e2981.member * _e664) + (_e2981.member_1 * _e669)) + (_e2981.member_2 * _e658)) + _e2981.member_3);
let _e3003 = select(_e3001, _e2995, (_e2995 < _e3001));
let _e3005 = select(_e3001, _e2995, (_e2995 > _e3001));
let _e3007 = (_e3005 - _e3003);
let _e3010 = (-(_e3003) / select(1e-30f, _e3007, (_e3007 > 1e-30f)));
let _e3012 = select(0f, _e3010, (_e3010 > 0f));
let _e3018 = select(select(select(1f, _e3012, (_e3012 < 1f)), 1f, (_e3005 <= 0f)), 0f, (_e3003 > 0f));
let _e3020 = (_e2985 > 0.5f);
let _e3029 = global_1.member.member_19;
let _e3033 = global_1.member.member_22.member_1;
let _e3043 = ((((_e3029.member * _e641) + (_e3029.member_1 * _e654)) + (_e3029.member_2 * _e619)) + _e3029.member_3);
let _e3049 = ((((_e3029.member * _e664) + (_e3029.member_1 * _e669)) + (_e3029.member_2 * _e658)) + _e3029.member_3);
let _e3051 = select(_e3049, _e3043, (_e3043 < _e3049));
let _e3053 = select(_e3049, _e3043, (_e3043 > _e3049));
let _e3055 = (_e3053 - _e3051);
let _e3058 = (-(_e3051) / select(1e-30f, _e3055, (_e3055 > 1e-30f)));
let _e3060 = select(0f, _e3058, (_e3058 > 0f));
let _e3066 = select(select(select(1f, _e3060, (_e3060 < 1f)), 1f, (_e3053 <= 0f)), 0f, (_e3051 > 0f));
let _e3068 = (_e3033 > 0.5f);
let _e3077 = global_1.member.member_20;
let _e3081 = global_1.member.member_22.member_2;
let _e3091 = ((((_e3077.member * _e641) + (_e3077.member_1 * _e654)) + (_e3077.member_2 * _e619)) + _e3077.member_3);
let _e3097 = ((((_e3077.member * _e664) + (_e3077.member_1 * _e669)) + (_e3077.member_2 * _e658)) + _e3077.member_3);
let _e3099 = select(_e3097, _e3091, (_e3091 < _e3097));
let _e3101 = select(_e3097, _e3091, (_e3091 > _e3097));
let _e3103 = (_e3101 - _e3099);
let _e3106 = (-(_e3099) / select(1e-30f, _e3103, (_e3103 > 1e-30f)));
let _e3108 = select(0f, _e3106, (_e3106 > 0f));
let _e3114 = select(select(select(1f, _e3108, (_e3108 < 1f)), 1f, (_e3101 <= 0f)), 0f, (_e3099 > 0f));
let _e3116 = (_e3081 > 0.5f);
let _e3125 = global_1.member.member_21;
let _e3129 = global_1.member.member_22.member_3;
let _e3139 = ((((_e3125.member * _e641) + (_e3125.member_1 * _e654)) + (_e3125.member_2 * _e619)) + _e3125.member_3);
let _e3145 = ((((_e3125.member * _e664) + (_e3125.member_1 * _e669)) + (_e3125.member_2 * _e658)) + _e3125.member_3);
let _e3147 = select(_e3145, _e3139, (_e3139 < _e3145));
let _e3149 = select(_e3145, _e3139, (_e3139 > _e3145));
let _e3151 = (_e3149 - _e3147);
let _e3154 = (-(_e3147) / select(1e-30f, _e3151, (_e3151 > 1e-30f)));
let _e3156 = select(0f, _e3154, (_e3154 > 0f));
let _e3162 = select(select(select(1f, _e3156, (_e3156 < 1f)), 1f, (_e3149 <= 0f)), 0f, (_e3147 > 0f));
let _e3164 = (_e3129 > 0.5f);
phi_8135_ = type_21(((((1f * _e3018) * _e3066) * _e3114) * _e3162), ((((1f * select(1f, _e3018, _e3020)) * select(1f, _e3066, _e3068)) * select(1f, _e3114, _e3116)) * select(1f, _e3162, _e3164)), ((((1f * select(1f, 0f, (_e3020 && (_e3001 > 0f)))) * select(1f, 0f, (_e3068 && (_e3049 > 0f)))) * select(1f, 0f, (_e3116 && (_e3097 > 0f)))) * select(1f, 0f, (_e3164 && (_e3145 > 0f)))));
}
let _e3173 = phi_8135_;
let _e3174 = (_e729 - _e687);
let _e3178 = (bitcast<f32>((bitcast<u32>(_e3174) & 2147483647u)) < 1e-12f);
let _e3180 = (1f / select(_e3174, 1f, _e3178));
let _e3182 = ((-0.5f - _e687) * _e3180);
let _e3184 = ((_e2597 - _e687) * _e3180);
let _e3190 = select(_e3184, _e3182, (_e3182 < _e3184));
let _e3192 = select(0f, _e3190, (_e3190 > 0f));
let _e3195 = select(select(1f, _e3192, (_e3192 < 1f)), select(2f, 0f, ((_e687 >= -0.5f) && (_e687 <= _e2597))), _e3178);
let _e3197 = select(_e3184, _e3182, (_e3182 > _e3184));
let _e3199 = select(0f, _e3197, (_e3197 > 0f));
let _e3202 = select(select(1f, _e3199, (_e3199 < 1f)), 1f, _e3178);
let _e3203 = (_e735 - _e705);
let _e3207 = (bitcast<f32>((bitcast<u32>(_e3203) & 2147483647u)) < 1e-12f);
let _e3209 = (1f / select(_e3203, 1f, _e3207));
let _e3211 = ((-0.5f - _e705) * _e3209);
let _e3213 = ((_e2607 - _e705) * _e3209);
let _e3219 = select(_e3213, _e3211, (_e3211 < _e3213));
let _e3221 = select(0f, _e3219, (_e3219 > 0f));
let _e3224 = select(select(1f, _e3221, (_e3221 < 1f)), select(2f, 0f, ((_e705 >= -0.5f) && (_e705 <= _e2607))), _e3207);
let _e3226 = select(_e3213, _e3211, (_e3211 > _e3213));
let _e3228 = select(0f, _e3226, (_e3226 > 0f));
let _e3231 = select(select(1f, _e3228, (_e3228 < 1f)), 1f, _e3207);
let _e3232 = (_e741 - _e723);
let _e3236 = (bitcast<f32>((bitcast<u32>(_e3232) & 2147483647u)) < 1e-12f);
let _e3238 = (1f / select(_e3232, 1f, _e3236));
let _e3240 = ((-0.5f - _e723) * _e3238);
let _e3242 = ((_e2617 - _e723) * _e3238);
let _e3248 = select(_e3242, _e3240, (_e3240 < _e3242));
let _e3250 = select(0f, _e3248, (_e3248 > 0f));
let _e3253 = select(select(1f, _e3250, (_e3250 < 1f)), select(2f, 0f, ((_e723 >= -0.5f) && (_e723 <= _e2617))), _e3236);
let _e3255 = select(_e3242, _e3240, (_e3240 > _e3242));
let _e3257 = select(0f, _e3255, (_e3255 > 0f));
let _e3260 = select(select(1f, _e3257, (_e3257 < 1f)), 1f, _e3236);
let _e3262 = select(_e3231, _e3202, (_e3202 < _e3231));
let _e3266 = select(_e3224, _e3195, (_e3195 > _e3224));
let _e3269 = (select(_e3260, _e3262, (_e3262 < _e3260)) - select(_e3253, _e3266, (_e3266 > _e3253)));
let _e3272 = (_e664 - _e641);
let _e3273 = (_e669 - _e654);
let _e3274 = (_e658 - _e619);
let _e3279 = (((_e3272 * _e3272) + (_e3273 * _e3273)) + (_e3274 * _e3274));
let _e3287 = global_1.member.member_4.member_3;
let _e3288 = ((sqrt(select(0f, _e3279, (_e3279 > 0f))) * select(0f, _e3269, (_e3269 > 0f))) * _e3287);
if (_e586 >= 3u) {
let _e3741 = (_e2972 * 255f);
let _e3742 = (_e2591.member * 255f);
let _e3743 = (255f - 1f);
let _e3745 = select(0f, _e3741, (_e3741 > 0f));
let _e3747 = select(_e3743, _e3745, (_e3745 < _e3743));
let _e3754 = select(0i, select(select(i32(_e3747), i32(-2147483648), (_e3747 < -2147483600f)), 2147483647i, (_e3747 > 2147483500f)), (_e3747 == _e3747));
let _e3758 = (_e3754 - select(0i, 1i, (_e3747 < f32(_e3754))));
let _e3760 = select(0f, _e3742, (_e3742 > 0f));
let _e3762 = select(_e3743, _e3760, (_e3760 < _e3743));
let _e3769 = select(0i, select(select(i32(_e3762), i32(-2147483648), (_e3762 < -2147483600f)), 2147483647i, (_e3762 > 2147483500f)), (_e3762 == _e3762));
let _e3773 = (_e3769 - select(0i, 1i, (_e3762 < f32(_e3769))));
let _e3776 = (((_e3758 * 256i) + _e3773) * 4i);
let _e3780 = (_e3742 - f32(_e3773));
let _e3782 = (bitcast<i32>(_e95) - 1i);
let _e3784 = select(_e3782, _e3776, (_e3776 < _e3782));
let _e3790 = global_4.member[bitcast<u32>(select(0i, _e3784, (_e3784 > 0i)))];
let _e3791 = (_e3776 + 4i);
let _e3793 = select(_e3782, _e3791, (_e3791 < _e3782));
let _e3799 = global_4.member[bitcast<u32>(select(0i, _e3793, (_e3793 > 0i)))];
let _e3800 = (_e3776 + 1024i);
let _e3802 = select(_e3782, _e3800, (_e3800 < _e3782));
let _e3808 = global_4.member[bitcast<u32>(select(0i, _e3802, (_e3802 > 0i)))];
let _e3809 = (_e3776 + 1028i);
let _e3811 = select(_e3782, _e3809, (_e3809 < _e3782));
let _e3817 = global_4.member[bitcast<u32>(select(0i, _e3811, (_e3811 > 0i)))];
let _e3822 = (bitcast<f32>(((_e3790 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3830 = (_e3822 + (((bitcast<f32>(((_e3799 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3822) * _e3780));
let _e3835 = (bitcast<f32>(((_e3808 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3846 = (_e3830 + (((_e3835 + (((bitcast<f32>(((_e3817 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3835) * _e3780)) - _e3830) * (_e3741 - f32(_e3758))));
let _e3850 = -((_e3846 * (_e3288 * _e3173.member)));
let _e3852 = select(-87f, _e3850, (_e3850 > -87f));
let _e3854 = select(88f, _e3852, (_e3852 < 88f));
let _e3856 = ((_e3854 * 1.442695f) + 0.5f);
let _e3858 = select(-127f, _e3856, (_e3856 > -127f));
let _e3860 = select(128f, _e3858, (_e3858 < 128f));
let _e3867 = select(0i, select(select(i32(_e3860), i32(-2147483648), (_e3860 < -2147483600f)), 2147483647i, (_e3860 > 2147483500f)), (_e3860 == _e3860));
let _e3871 = (_e3867 - select(0i, 1i, (_e3860 < f32(_e3867))));
let _e3872 = f32(_e3871);
let _e3876 = ((_e3854 - (_e3872 * 0.6933594f)) - (_e3872 * -2.1219444e-4f));
let _e3896 = ((1f + (_e3876 * (1f + (_e3876 * (0.5f + (_e3876 * (0.16666667f + (_e3876 * (0.041666668f + (_e3876 * (0.008333334f + (_e3876 * (0.001388889f + (_e3876 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3871 + 127i)) << bitcast<u32>(23i))));
let _e3897 = (1f - _e3896);
phi_9245_ = type_22(_e3896, _e3897, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e3897 / select(1e-12f, _e3846, (_e3846 > 1e-12f))))));
} else {
let _e3291 = (_e2972 * 255f);
let _e3292 = (_e2591.member * 255f);
let _e3293 = (255f - 1f);
let _e3295 = select(0f, _e3291, (_e3291 > 0f));
let _e3297 = select(_e3293, _e3295, (_e3295 < _e3293));
let _e3304 = select(0i, select(select(i32(_e3297), i32(-2147483648), (_e3297 < -2147483600f)), 2147483647i, (_e3297 > 2147483500f)), (_e3297 == _e3297));
let _e3308 = (_e3304 - select(0i, 1i, (_e3297 < f32(_e3304))));
let _e3310 = select(0f, _e3292, (_e3292 > 0f));
let _e3312 = select(_e3293, _e3310, (_e3310 < _e3293));
let _e3319 = select(0i, select(select(i32(_e3312), i32(-2147483648), (_e3312 < -2147483600f)), 2147483647i, (_e3312 > 2147483500f)), (_e3312 == _e3312));
let _e3323 = (_e3319 - select(0i, 1i, (_e3312 < f32(_e3319))));
let _e3326 = (((_e3308 * 256i) + _e3323) * 4i);
let _e3328 = (_e3291 - f32(_e3308));
let _e3330 = (_e3292 - f32(_e3323));
let _e3332 = (bitcast<i32>(_e95) - 1i);
let _e3334 = select(_e3332, _e3326, (_e3326 < _e3332));
let _e3340 = global_4.member[bitcast<u32>(select(0i, _e3334, (_e3334 > 0i)))];
let _e3341 = (_e3326 + 4i);
let _e3343 = select(_e3332, _e3341, (_e3341 < _e3332));
let _e3349 = global_4.member[bitcast<u32>(select(0i, _e3343, (_e3343 > 0i)))];
let _e3350 = (_e3326 + 1024i);
let _e3352 = select(_e3332, _e3350, (_e3350 < _e3332));
let _e3358 = global_4.member[bitcast<u32>(select(0i, _e3352, (_e3352 > 0i)))];
let _e3359 = (_e3326 + 1028i);
let _e3361 = select(_e3332, _e3359, (_e3359 < _e3332));
let _e3367 = global_4.member[bitcast<u32>(select(0i, _e3361, (_e3361 > 0i)))];
let _e3372 = (bitcast<f32>(((_e3340 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3380 = (_e3372 + (((bitcast<f32>(((_e3349 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3372) * _e3330));
let _e3385 = (bitcast<f32>(((_e3358 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3396 = (_e3380 + (((_e3385 + (((bitcast<f32>(((_e3367 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3385) * _e3330)) - _e3380) * _e3328));
let _e3409 = (bitcast<f32>((((_e3340 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3417 = (_e3409 + (((bitcast<f32>((((_e3349 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3409) * _e3330));
let _e3422 = (bitcast<f32>((((_e3358 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3434 = (_e3326 + 1i);
let _e3436 = select(_e3332, _e3434, (_e3434 < _e3332));
let _e3442 = global_4.member[bitcast<u32>(select(0i, _e3436, (_e3436 > 0i)))];
let _e3443 = (_e3326 + 5i);
let _e3445 = select(_e3332, _e3443, (_e3443 < _e3332));
let _e3451 = global_4.member[bitcast<u32>(select(0i, _e3445, (_e3445 > 0i)))];
let _e3452 = (_e3326 + 1025i);
let _e3454 = select(_e3332, _e3452, (_e3452 < _e3332));
let _e3460 = global_4.member[bitcast<u32>(select(0i, _e3454, (_e3454 > 0i)))];
let _e3461 = (_e3326 + 1029i);
let _e3463 = select(_e3332, _e3461, (_e3461 < _e3332));
let _e3469 = global_4.member[bitcast<u32>(select(0i, _e3463, (_e3463 > 0i)))];
let _e3474 = (bitcast<f32>(((_e3442 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3482 = (_e3474 + (((bitcast<f32>(((_e3451 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3474) * _e3330));
let _e3487 = (bitcast<f32>(((_e3460 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3511 = (bitcast<f32>((((_e3442 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3519 = (_e3511 + (((bitcast<f32>((((_e3451 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3511) * _e3330));
let _e3524 = (bitcast<f32>((((_e3460 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3539 = (_e3288 * _e3173.member_1);
let _e3541 = -(((_e3417 + (((_e3422 + (((bitcast<f32>((((_e3367 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3422) * _e3330)) - _e3417) * _e3328)) * _e3539));
let _e3543 = select(-87f, _e3541, (_e3541 > -87f));
let _e3545 = select(88f, _e3543, (_e3543 < 88f));
let _e3547 = ((_e3545 * 1.442695f) + 0.5f);
let _e3549 = select(-127f, _e3547, (_e3547 > -127f));
let _e3551 = select(128f, _e3549, (_e3549 < 128f));
let _e3558 = select(0i, select(select(i32(_e3551), i32(-2147483648), (_e3551 < -2147483600f)), 2147483647i, (_e3551 > 2147483500f)), (_e3551 == _e3551));
let _e3562 = (_e3558 - select(0i, 1i, (_e3551 < f32(_e3558))));
let _e3563 = f32(_e3562);
let _e3567 = ((_e3545 - (_e3563 * 0.6933594f)) - (_e3563 * -2.1219444e-4f));
let _e3589 = -(((_e3482 + (((_e3487 + (((bitcast<f32>(((_e3469 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3487) * _e3330)) - _e3482) * _e3328)) * _e3539));
let _e3591 = select(-87f, _e3589, (_e3589 > -87f));
let _e3593 = select(88f, _e3591, (_e3591 < 88f));
let _e3595 = ((_e3593 * 1.442695f) + 0.5f);
let _e3597 = select(-127f, _e3595, (_e3595 > -127f));
let _e3599 = select(128f, _e3597, (_e3597 < 128f));
let _e3606 = select(0i, select(select(i32(_e3599), i32(-2147483648), (_e3599 < -2147483600f)), 2147483647i, (_e3599 > 2147483500f)), (_e3599 == _e3599));
let _e3610 = (_e3606 - select(0i, 1i, (_e3599 < f32(_e3606))));
let _e3611 = f32(_e3610);
let _e3615 = ((_e3593 - (_e3611 * 0.6933594f)) - (_e3611 * -2.1219444e-4f));
let _e3637 = -(((_e3519 + (((_e3524 + (((bitcast<f32>((((_e3469 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3524) * _e3330)) - _e3519) * _e3328)) * _e3539));
let _e3639 = select(-87f, _e3637, (_e3637 > -87f));
let _e3641 = select(88f, _e3639, (_e3639 < 88f));
let _e3643 = ((_e3641 * 1.442695f) + 0.5f);
let _e3645 = select(-127f, _e3643, (_e3643 > -127f));
let _e3647 = select(128f, _e3645, (_e3645 < 128f));
let _e3654 = select(0i, select(select(i32(_e3647), i32(-2147483648), (_e3647 < -2147483600f)), 2147483647i, (_e3647 > 2147483500f)), (_e3647 == _e3647));
let _e3658 = (_e3654 - select(0i, 1i, (_e3647 < f32(_e3654))));
let _e3659 = f32(_e3658);
let _e3663 = ((_e3641 - (_e3659 * 0.6933594f)) - (_e3659 * -2.1219444e-4f));
let _e3686 = -((_e3396 * (_e3288 * _e3173.member)));
let _e3688 = select(-87f, _e3686, (_e3686 > -87f));
let _e3690 = select(88f, _e3688, (_e3688 < 88f));
let _e3692 = ((_e3690 * 1.442695f) + 0.5f);
let _e3694 = select(-127f, _e3692, (_e3692 > -127f));
let _e3696 = select(128f, _e3694, (_e3694 < 128f));
let _e3703 = select(0i, select(select(i32(_e3696), i32(-2147483648), (_e3696 < -2147483600f)), 2147483647i, (_e3696 > 2147483500f)), (_e3696 == _e3696));
let _e3707 = (_e3703 - select(0i, 1i, (_e3696 < f32(_e3703))));
let _e3708 = f32(_e3707);
let _e3712 = ((_e3690 - (_e3708 * 0.6933594f)) - (_e3708 * -2.1219444e-4f));
let _e3732 = ((1f + (_e3712 * (1f + (_e3712 * (0.5f + (_e3712 * (0.16666667f + (_e3712 * (0.041666668f + (_e3712 * (0.008333334f + (_e3712 * (0.001388889f + (_e3712 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3707 + 127i)) << bitcast<u32>(23i))));
let _e3733 = (1f - _e3732);
phi_9245_ = type_22(_e3732, _e3733, vec3<f32>(((1f + (_e3567 * (1f + (_e3567 * (0.5f + (_e3567 * (0.16666667f + (_e3567 * (0.041666668f + (_e3567 * (0.008333334f + (_e3567 * (0.001388889f + (_e3567 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3562 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3615 * (1f + (_e3615 * (0.5f + (_e3615 * (0.16666667f + (_e3615 * (0.041666668f + (_e3615 * (0.008333334f + (_e3615 * (0.001388889f + (_e3615 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3610 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3663 * (1f + (_e3663 * (0.5f + (_e3663 * (0.16666667f + (_e3663 * (0.041666668f + (_e3663 * (0.008333334f + (_e3663 * (0.001388889f + (_e3663 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3658 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e3733 / select(1e-12f, _e3396, (_e3396 > 1e-12f))))));
}
let _e3905 = phi_9245_;
if _e746 {
let _e3909 = global_1.member.member_4.member_2;
let _e3917 = global_1.member.member_24.member_2;
let _e3920 = (_e2591.member_3.x * _e3173.member_2);
let _e3922 = (_e2591.member_3.y * _e3173.member_2);
let _e3924 = (_e2591.member_3.z * _e3173.member_2);
let _e3925 = (0.5f * (_e3909 / select(1e-6f, _e188, (_e188 > 1e-6f))));
let _e3929 = (_e166 + (_e3920 * _e3925));
let _e3930 = (_e177 + (_e3922 * _e3925));
let _e3931 = (_e188 + (_e3924 * _e3925));
let _e3933 = (2f * _e3909);
let _e3935 = ((_e3931 * _e3931) + (_e3933 * _e3924));
let _e3939 = (_e3931 + sqrt(select(0f, _e3935, (_e3935 > 0f))));
let _e3943 = (0.5f * (_e3933 / select(1e-6f, _e3939, (_e3939 > 1e-6f))));
let _e3947 = (_e3929 + (_e3920 * _e3943));
let _e3948 = (_e3930 + (_e3922 * _e3943));
let _e3949 = (_e3931 + (_e3924 * _e3943));
let _e3953 = (_e3917 * _e3917);
let _e3955 = (_e3949 * _e3949);
let _e3963 = (((_e3931 <= 0f) || (_e3935 <= 0f)) || ((_e3949 <= 0f) || (_e3955 <= (_e3953 * (((_e3947 * _e3947) + (_e3948 * _e3948)) + _e3955)))));
let _e3977 = (_e166 + ((_e2591.member_4.x * _e3173.member_2) * _e3909));
let _e3978 = (_e177 + ((_e2591.member_4.y * _e3173.member_2) * _e3909));
let _e3979 = (_e188 + ((_e2591.member_4.z * _e3173.member_2) * _e3909));
let _e3981 = (_e3979 * _e3979);
let _e3990 = ((_e2976 & 1u) != 0u);
let _e3994 = select(_e3963, ((_e3979 <= 0f) || (_e3981 <= (_e3953 * (((_e3977 * _e3977) + (_e3978 * _e3978)) + _e3981)))), _e3990);
phi_9396_ = select(select(select(_e3949, _e3931, _e3963), _e3979, _e3990), _e188, _e3994);
phi_9397_ = select(select(select(_e3948, _e3930, _e3963), _e3978, _e3990), _e177, _e3994);
phi_9398_ = select(select(select(_e3947, _e3929, _e3963), _e3977, _e3990), _e166, _e3994);
phi_9399_ = select(1f, 0f, _e3994);
} else {
phi_9396_ = _e188;
phi_9397_ = _e177;
phi_9398_ = _e166;
phi_9399_ = 1f;
}
let _e4000 = phi_9396_;
let _e4002 = phi_9397_;
let _e4004 = phi_9398_;
let _e4006 = phi_9399_;
let _e4009 = (_e3905.member * _e4006);
global_5.member[_e123] = (_e134 * (_e3905.member_2.x * _e4009));
global_5.member[_e135] = (_e144 * (_e3905.member_2.y * _e4009));
global_5.member[_e146] = (_e155 * (_e3905.member_2.z * _e4009));
global_5.member[_e157] = _e4004;
global_5.member[_e168] = _e4002;
global_5.member[_e179] = _e4000;
global_5.member[_e190] = _e199;
global_5.member[_e201] = _e210;
global_5.member[_e212] = _e221;
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
